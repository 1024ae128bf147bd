//! MOT-08: the three points of an arc lie on a line.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "points-on-a-line",
    title: "The three points of an arc lie on a line.",
    verdicts: Verdicts::contouring("MOT-08", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.2.2")],
    page: page!("MOT-08"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::OnALine = event.kind else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "Start, intermediate and end point of the arc coincide or lie on a line: no circle goes through them. Correct \
         one, or use G01."
            .to_owned(),
    );
}
