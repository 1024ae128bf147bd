//! NUM-04: zeros may be left out of dimension words only.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "zeros-left-out",
    title: "Zeros may be left out of dimension words only.",
    verdicts: Verdicts::all("NUM-04", Severity::Error),
    clauses: &[Clause::Both("3.3.1")],
    page: page!("NUM-04"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address) else { return };
    // FEED-07 and FEED-09 name the code that has not its digits.
    if crate::rules::feed::coding(word.address, block.control).is_some() {
        return;
    }
    let wanted = u16::from(designation.width());
    if matches!(word.address, b'F' | b'S')
        && word.fault == NumberFault::None
        && word.digits < wanted
        && !super::is_cut_by_letter(word, block)
    {
        let message = format!(
            "{} has {}; this format wants {wanted} ({}). Zeros may be left out of dimension words only.",
            word.letter(),
            digits(word.digits),
            designation.text()
        );
        sink.report(&RULE, word.range(), message);
    }
}
