//! MOT-04: the end of an arc is off its circle.

use crate::execute::{ArcFault, Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "end-off-the-circle",
    title: "The end of an arc is off its circle.",
    verdicts: Verdicts::contouring("MOT-04", Severity::Error),
    clauses: &[Clause::Iso2539("figure 2")],
    page: page!("MOT-04"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let (places, unit) = (tape.places(), tape.control.unit.name());
    let message = match event.kind {
        EventKind::Arc(ArcFault::RadiusMismatch { start, end, tolerance, fits: None, .. }) => format!(
            "The end is not on the circle: the radius is {start:.places$} at the start and {end:.places$} at the end; they \
             may differ by {tolerance:.4} {unit}. Correct the end point or the centre."
        ),
        EventKind::Arc(ArcFault::ChordMismatch { chord, ends, tolerance }) => format!(
            "Angle I and radius J make a chord of {chord:.places$}, but the end is {ends:.places$} from the start; they may \
             differ by {tolerance:.4} {unit}. Correct the end point, the angle or the radius."
        ),
        _ => return,
    };
    sink.report(&RULE, tape.parameters(event.block), message);
}
