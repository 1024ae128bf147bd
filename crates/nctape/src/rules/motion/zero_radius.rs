//! MOT-06: the radius of an arc is zero.

use crate::execute::ArcFault;
use crate::execute::{Event, EventKind};
use crate::format::ArcParameters;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "zero-radius",
    title: "The radius of an arc is zero.",
    verdicts: Verdicts::contouring("MOT-06", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.2")],
    page: page!("MOT-06"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Arc(ArcFault::ZeroRadius) = event.kind else { return };
    let message = match tape.control.arc_parameters {
        ArcParameters::Centre => "The centre of the arc is its start point: the radius is zero. Correct I, J and K.",
        ArcParameters::AngleRadius => "The radius J of the arc is zero. Correct it.",
    };
    sink.report(&RULE, tape.parameters(event.block), message.to_owned());
}
