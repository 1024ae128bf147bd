//! MOT-12: a parabola lacks its last point.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unfinished-parabola",
    title: "A parabola lacks its last point.",
    verdicts: Verdicts::contouring("MOT-12", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.3.2")],
    page: page!("MOT-12"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Unfinished { parabola: true } = event.kind else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "A parabola without I, J and K has two blocks, intermediate point and end point; the points under G06 are odd \
         in number and this one is left over. Add its end point, or give the tangent intersection point."
            .to_owned(),
    );
}
