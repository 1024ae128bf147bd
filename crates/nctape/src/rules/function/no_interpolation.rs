//! FUN-05: motion stands before any interpolation code.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-without-interpolation",
    title: "Motion stands before any interpolation code.",
    verdicts: Verdicts::contouring("FUN-05", Severity::Warning).rs274_as(Severity::Info),
    clauses: &[Clause::Iso2539("4.2.1 a")],
    page: page!("FUN-05"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter(|event| matches!(event.kind, EventKind::NoInterpolation));
    let Some(event) = found.next() else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The block moves before any G00, G01, G02, G03 or G06 was given; it is read as G01. Put the function before it."
            .to_owned(),
    )
    .count(1 + found.count());
}
