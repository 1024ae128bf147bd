//! MOT-13: a parabola has no bend.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "degenerate-parabola",
    title: "A parabola has no bend.",
    verdicts: Verdicts::contouring("MOT-13", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.3"), Clause::Iso2539("figure 3")],
    page: page!("MOT-13"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Degenerate { intermediate } = event.kind else { return };
    let what = if intermediate { "intermediate point" } else { "tangent intersection point" };
    let message =
        format!("The {what} lies on the line through the ends: that is no parabola. Correct the point, or use G01.");
    sink.report(&RULE, tape.extent(event.block), message);
}
