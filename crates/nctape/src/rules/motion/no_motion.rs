//! MOT-18: a block moves nothing.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "no-motion",
    title: "A block moves nothing.",
    verdicts: Verdicts::all("MOT-18", Severity::Info),
    clauses: &[],
    page: page!("MOT-18"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter(|event| matches!(event.kind, EventKind::NoMotion));
    let Some(event) = found.next() else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The dimension words of this block move nothing: the tool stands there already.".to_owned(),
    )
    .count(1 + found.count());
}
