//! NUM-03: a decimal sign stands on the tape.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "decimal-sign",
    title: "A decimal sign stands on the tape.",
    verdicts: Verdicts::all("NUM-03", Severity::Error),
    clauses: &[Clause::Both("3.3.3.3")],
    page: page!("NUM-03"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let NumberFault::DecimalSign(at) = word.fault else { return };
    let at = at as usize;
    let place = block.control.designation(word.address).filter(|place| place.dimension || place.after > 0);
    let (advice, fix) = match place.and_then(|designation| {
        let number = &block.text[word.range()];
        let exact = without_decimal_sign(number, designation.before, designation.after)?;
        Some((format!("Write {exact} ({}).", designation.text()), exact))
    }) {
        Some((advice, fix)) => (advice, Some(fix)),
        None => ("Leave it out and write the digits that the format wants.".to_owned(), None),
    };
    let message = format!(
        "{} has a decimal sign; the tape has none, the format says where it is understood. {advice}",
        word.letter()
    );
    let reported = sink.report(&RULE, at..at + 1, message);
    if let Some(exact) = fix {
        reported.fix(|| Fix::replace(format!("Write {exact}"), word.range(), exact));
    }
}

/// The word with all digits of its designation and no decimal sign; `None` where its digits do not fit.
fn without_decimal_sign(text: &str, before: u8, after: u8) -> Option<String> {
    let first = text.find(|c: char| c.is_ascii_digit() || matches!(c, '.' | ','))?;
    let (head, number) = text.split_at(first);
    let (whole, part) = number.split_once(['.', ','])?;
    let (before, after) = (usize::from(before), usize::from(after));
    let plain = |digits: &str| digits.bytes().all(|byte| byte.is_ascii_digit());
    if !plain(whole) || !plain(part) {
        return None;
    }
    let whole = whole.trim_start_matches('0');
    let part = part.trim_end_matches('0');
    (whole.len() <= before && part.len() <= after).then(|| format!("{head}{whole:0>before$}{part:0<after$}"))
}
