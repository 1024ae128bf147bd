//! MOT-01: more axes move at once than the control can.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "too-many-axes",
    title: "More axes move at once than the control can.",
    verdicts: Verdicts::contouring("MOT-01", Severity::Error).not_rs274().and_iso1058("MOT-01", Severity::Info),
    clauses: &[Clause::Both("C.2.3")],
    page: page!("MOT-01"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::TooManyAxes { ref moving, allowed, positioning } = event.kind else { return };
    let (severity, effect) = if positioning {
        (Severity::Info, "the control moves them one after another.")
    } else {
        (Severity::Error, "the control cannot contour that. Divide the move.")
    };
    let message = format!(
        "{} axes move in this block ({moving}); the third digit of the classification allows {allowed} at a time: \
         {effect}",
        moving.chars().count()
    );
    sink.report_as(severity, &RULE, tape.extent(event.block), message);
}
