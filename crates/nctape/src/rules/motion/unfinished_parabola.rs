//! MOT-12: a parabola or a cubic lacks its last points.

use crate::execute::{Event, EventKind, Several};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unfinished-parabola",
    title: "A parabola or a cubic lacks its last points.",
    verdicts: Verdicts::contouring("MOT-12", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.3.2"), Clause::Iso2539("4.2.4")],
    page: page!("MOT-12"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let message = match event.kind {
        EventKind::Unfinished(Several::Parabola) => {
            "A parabola without I, J and K has two blocks, intermediate point and end point; the points under G06 are odd \
         in number and this one is left over. Add its end point, or give I, J and K."
        }
        EventKind::Unfinished(Several::Curve) => {
            "A cubic has three blocks, two intermediate points and the end point; the points under its G code are no \
             multiple of three in number, and those from this one on are left over. Add what is missing."
        }
        _ => return,
    };
    sink.report(&RULE, tape.extent(event.block), message.to_owned());
}
