//! MOT-14: a parabola is strongly skewed.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "skewed-parabola",
    title: "A parabola is strongly skewed, or turns back on its way.",
    verdicts: Verdicts::contouring("MOT-14", Severity::Info),
    clauses: &[Clause::Iso2539("figure 3")],
    page: page!("MOT-14"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let message = match event.kind {
        EventKind::Skewed => {
            "The intermediate point is far from opposite the middle of the chord, so the parabola is strongly skewed. Its \
         tangent there is taken as parallel to the chord (figure 3): see whether that is the curve that is meant."
        }
        EventKind::TurnsBack => {
            "The tangents of these slopes meet beside the two ends, so the parabola turns back on its way: see whether \
             that is the curve that is meant."
        }
        _ => return,
    };
    sink.report(&RULE, tape.extent(event.block), message.to_owned());
}
