//! MOT-10: an arc leaves its quadrant.

use crate::execute::{ArcFault, Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "arc-leaves-quadrant",
    title: "An arc leaves its quadrant.",
    verdicts: Verdicts::contouring("MOT-10", Severity::Error),
    clauses: &[Clause::Iso2539("4.1.4"), Clause::Iso2539("4.2.2")],
    page: page!("MOT-10"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Arc(ArcFault::LeavesQuadrant) = event.kind else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The arc leaves the quadrant in which it starts; with I, J and K without sign (arcCentre: quadrant) an arc stays \
         within one. Divide it where it crosses a line through the centre parallel to an axis."
            .to_owned(),
    );
}
