//! FEED-05: the reciprocal of time is used on a parabola.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "reciprocal-on-parabola",
    title: "The reciprocal of time is used on a parabola.",
    verdicts: Verdicts::contouring("FEED-05", Severity::Warning),
    clauses: &[Clause::Iso2539("A.1.3")],
    page: page!("FEED-05"),
};

/// Said once, with how many parabolas it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter(|event| matches!(event.kind, EventKind::ReciprocalParabola));
    let Some(event) = found.next() else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "F is the reciprocal of time, which is not generally applicable to parabolas; here it is read as on a line, the \
         time of the whole span. Use a feed per minute on parabolas, if the control has it."
            .to_owned(),
    )
    .count(1 + found.count());
}
