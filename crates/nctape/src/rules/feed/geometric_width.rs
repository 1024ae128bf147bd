//! FEED-09: a geometric code has not two digits.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "geometric-code-not-two-digits",
    title: "A geometric code has not two digits.",
    verdicts: Verdicts::all("FEED-09", Severity::Error),
    clauses: &[Clause::Iso2539("A.3"), Clause::Iso1058("A.2.1")],
    page: page!("FEED-09"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address) else { return };
    if super::coding(word.address, block.control) != Some(crate::format::FeedCoding::Geometric)
        || word.fault != NumberFault::None
    {
        return;
    }
    if word.digits == 2 {
        return;
    }
    let message = format!(
        "{} has {}; a code of the geometric progression has exactly 2, 00 to 99 ({}2). Write both.",
        word.letter(),
        digits(word.digits),
        designation.address
    );
    sink.report(&RULE, word.range(), message);
}
