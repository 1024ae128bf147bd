//! NUM-18: a tool word has not the digits that the format says.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tool-word-off-format",
    title: "A tool word has not the digits that the format says.",
    verdicts: Verdicts::all("NUM-18", Severity::Error),
    clauses: &[Clause::Both("3.3.4.5")],
    page: page!("NUM-18"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(b'T') else { return };
    let wanted = u16::from(designation.width());
    if word.address == b'T'
        && word.fault == NumberFault::None
        && word.digits != wanted
        && !super::is_cut_by_letter(word, block)
    {
        let message = format!("T has {}; this format wants {wanted} ({}).", digits(word.digits), designation.text());
        sink.report(&RULE, word.range(), message);
    }
}
