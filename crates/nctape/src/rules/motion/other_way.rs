//! MOT-09: a three-point arc runs the other way than its function says.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "arc-runs-the-other-way",
    title: "A three-point arc runs the other way than its function says.",
    verdicts: Verdicts::contouring("MOT-09", Severity::Warning),
    clauses: &[Clause::Iso2539("4.2.2.2 a")],
    page: page!("MOT-09"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::OtherWay { clockwise } = event.kind else { return };
    let (said, runs) =
        if clockwise { ("G02, clockwise", "counter-clockwise") } else { ("G03, counter-clockwise", "clockwise") };
    let message = format!(
        "The function is {said}, but the arc through the three points runs {runs}; it is drawn through the points. \
         Correct the function or the points."
    );
    sink.report(&RULE, tape.extent(event.block), message);
}
