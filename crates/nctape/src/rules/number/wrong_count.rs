//! NUM-01: a word has not the digits that the format says.

use crate::format::Zeros;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-digit-count",
    title: "A word has not the digits that the format says.",
    verdicts: Verdicts::all("NUM-01", Severity::Error),
    clauses: &[Clause::Both("D.3.1")],
    page: page!("NUM-01"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address) else { return };
    if word.fault != NumberFault::None || matches!(word.address, b'N' | b'G' | b'M' | b'T' | b'F' | b'S') {
        return;
    }
    let wanted = u16::from(designation.width());
    let wrong = match designation.zeros {
        Zeros::All if designation.dimension => word.digits < wanted,
        Zeros::All => word.digits != wanted,
        _ => false,
    };
    if !wrong || super::is_short_zero(word, designation) || super::is_cut_by_letter(word, block) {
        return;
    }
    let message =
        format!("{} has {}; this format wants {wanted} ({}).", word.letter(), digits(word.digits), designation.text());
    sink.report(&RULE, word.range(), message).fix(|| {
        let text = &block.text[word.range()];
        let padded = pad(text, wanted.saturating_sub(word.digits));
        Fix::replace(format!("Fill it up with zeros in front: {padded}"), word.range(), padded)
    });
}

/// Puts zeros before the first digit.
fn pad(text: &str, zeros: u16) -> String {
    let first = text.find(|c: char| c.is_ascii_digit()).unwrap_or(text.len());
    format!("{}{}{}", &text[..first], "0".repeat(usize::from(zeros)), &text[first..])
}
