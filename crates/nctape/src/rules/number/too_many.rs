//! NUM-02: a word has more digits than the format allows.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "too-many-digits",
    title: "A word has more digits than the format allows.",
    verdicts: Verdicts::all("NUM-02", Severity::Error),
    clauses: &[Clause::Both("D.3.1")],
    page: page!("NUM-02"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address) else { return };
    // FEED-07 and FEED-09 name the code that has not its digits.
    if crate::rules::feed::coding(word.address, block.control).is_some() {
        return;
    }
    let counts = designation.dimension || matches!(word.address, b'F' | b'S');
    let allowed = u16::from(designation.width());
    if counts && word.fault == NumberFault::None && word.digits > allowed {
        let message = format!(
            "{} has {}; this format allows {allowed} ({}).",
            word.letter(),
            digits(word.digits),
            designation.text()
        );
        sink.report(&RULE, word.range(), message);
    }
}
