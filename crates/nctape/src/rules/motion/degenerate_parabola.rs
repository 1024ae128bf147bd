//! MOT-13: no parabola has these points or parameters.

use crate::execute::{Event, EventKind, ParabolaFault};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "degenerate-parabola",
    title: "What is given determines no parabola.",
    verdicts: Verdicts::contouring("MOT-13", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.3"), Clause::Iso2539("figure 3")],
    page: page!("MOT-13"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Parabola(fault) = event.kind else { return };
    let on_chord = |what: &str| {
        format!("The {what} lies on the line through the ends: that is no parabola. Correct the point, or use G01.")
    };
    let message = match fault {
        ParabolaFault::Intermediate => on_chord("intermediate point"),
        ParabolaFault::Tangent => on_chord("tangent intersection point"),
        ParabolaFault::NoSlope(index) => format!(
            "{} is missing: I is the slope at the start and J that at the end (parabolaParameters: slope). Give both.",
            ["I", "J"][index.min(1)]
        ),
        ParabolaFault::Parallel => {
            "The slopes at start and end are equal, so that the tangents do not meet: that is no \
             parabola. Correct I or J, or use G01."
                .to_owned()
        }
        ParabolaFault::SlopeOfChord => {
            "The tangent at one end runs through the other: that is no parabola. Correct I or J, \
             or use G01."
                .to_owned()
        }
        ParabolaFault::FocusAtEnd => {
            "The focus is the start or the end of the span: that is no parabola. Correct I, J and K.".to_owned()
        }
        ParabolaFault::FocusBetween => {
            "The focus lies on the line through the ends and between them: two parabolas fit, one \
             on each side. Divide the span, or correct I, J and K."
                .to_owned()
        }
        ParabolaFault::FocusOnLine => {
            "The focus lies on the line through the ends: no parabola about it runs through both. \
             Correct I, J and K, or use G01."
                .to_owned()
        }
    };
    sink.report(&RULE, tape.extent(event.block), message);
}
