//! FEED-07: an arithmetic code has not the digits of the format.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "arithmetic-code-off-format",
    title: "An arithmetic code has not the digits of the format.",
    verdicts: Verdicts::all("FEED-07", Severity::Error),
    clauses: &[Clause::Iso2539("A.2.2"), Clause::Iso1058("A.1.1")],
    page: page!("FEED-07"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address) else { return };
    if super::coding(word.address, block.control) != Some(crate::format::FeedCoding::Arithmetic)
        || word.fault != NumberFault::None
    {
        return;
    }
    let wanted = u16::from(designation.width());
    if word.digits == wanted {
        return;
    }
    let message = format!(
        "{} has {}; an arithmetic code has {wanted} here ({}). Its first digit is the magnitude, the others are the \
         speed: write all of them.",
        word.letter(),
        digits(word.digits),
        designation.text()
    );
    sink.report(&RULE, word.range(), message);
}
