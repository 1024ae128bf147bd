//! FEED-13: a cutting block has no feed.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "cutting-without-feed",
    title: "A cutting block has no feed.",
    verdicts: Verdicts::all("FEED-13", Severity::Error),
    clauses: &[Clause::Iso2539("A.1 to A.5"), Clause::Iso1058("A.1 to A.3")],
    page: page!("FEED-13"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter(|event| matches!(event.kind, EventKind::NoFeed));
    let Some(event) = found.next() else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The block cuts, but no F was given yet, or it is zero. Give the feed here or before.".to_owned(),
    )
    .count(1 + found.count());
}
