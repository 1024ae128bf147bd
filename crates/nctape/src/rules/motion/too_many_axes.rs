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

/// A move that the control cannot contour.
pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::TooManyAxes { moving, allowed, positioning: false } = event.kind else { return };
    let message = told(moving, allowed, tape, "the control cannot contour that. Divide the move.");
    sink.report_as(Severity::Error, &RULE, tape.extent(event.block), message);
}

/// Positioning moves: nothing is wrong, so it is said once, with how many blocks it holds for.
pub(crate) fn check_positioning(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter_map(|event| match event.kind {
        EventKind::TooManyAxes { moving, allowed, positioning: true } => Some((event.block, moving, allowed)),
        _ => None,
    });
    let Some((block, moving, allowed)) = found.next() else { return };
    let message = told(moving, allowed, tape, "the control moves them one after another.");
    sink.report_as(Severity::Info, &RULE, tape.extent(block), message).count(1 + found.count());
}

fn told(moving: u32, allowed: u8, tape: &TapeView<'_>, effect: &str) -> String {
    let axes = tape.control.axes.iter().enumerate().filter(|(axis, _)| moving >> axis & 1 == 1);
    let moving: String = axes.map(|(_, axis)| axis.letter).collect();
    format!(
        "{} axes move in this block ({moving}); the third digit of the classification allows {allowed} at a time: \
         {effect}",
        moving.chars().count()
    )
}
