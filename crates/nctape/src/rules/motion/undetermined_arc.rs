//! MOT-21: angle and radius determine no arc.

use crate::execute::{ArcFault, Event, EventKind, Lack};
use crate::format::Angles;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "undetermined-arc",
    title: "Angle and radius determine no arc.",
    verdicts: Verdicts::contouring("MOT-21", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.2.1"), Clause::Iso2539("figure 2")],
    page: page!("MOT-21"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Arc(ArcFault::NotDetermined(lack)) = event.kind else { return };
    let full_turn = match tape.control.angles() {
        Angles::Turns => "1 turn",
        Angles::Degrees => "360 degrees",
    };
    let message = match lack {
        Lack::Angle => {
            "I is missing: an arc by angle and radius has its included angle in I and its radius in J. Give both."
                .to_owned()
        }
        Lack::Radius => {
            "J is missing: an arc by angle and radius has its included angle in I and its radius in J. Give both."
                .to_owned()
        }
        Lack::AngleRange => format!(
            "The included angle I of an arc is above zero and below {full_turn}; its sense is that of G02 or G03. Correct \
             I, and write a full circle as two arcs."
        ),
        Lack::NegativeRadius => {
            "The radius J of an arc has no sense: that is G02 or G03. Write it without a minus.".to_owned()
        }
        Lack::Closed => {
            "The arc ends where it starts, and angle and radius do not say in which direction its centre lies: \
             a full circle cannot be written so. Write it as two arcs."
                .to_owned()
        }
    };
    sink.report(&RULE, tape.parameters(event.block), message);
}
