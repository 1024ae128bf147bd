//! FEED-02: a block takes over the reciprocal of another block's time.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "feed-carried-over",
    title: "A block takes over the reciprocal of another block's time.",
    verdicts: Verdicts::contouring("FEED-02", Severity::Warning),
    clauses: &[Clause::Iso2539("A.1"), Clause::Iso2539("3.2.3")],
    page: page!("FEED-02"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter(|event| matches!(event.kind, EventKind::NoOwnFeed));
    let Some(event) = found.next() else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The feed is the reciprocal of the time for a block, so every block that cuts needs its own F; this one takes over \
         the last. Write its F."
            .to_owned(),
    )
    .count(1 + found.count());
}
