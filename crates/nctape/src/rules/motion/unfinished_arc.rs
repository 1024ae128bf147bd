//! MOT-07: an arc in two blocks lacks its second one.

use crate::execute::{Event, EventKind, Several};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unfinished-arc",
    title: "An arc in two blocks lacks its second one.",
    verdicts: Verdicts::contouring("MOT-07", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.2.2")],
    page: page!("MOT-07"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Unfinished(Several::Arc) = event.kind else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "An arc without I, J and K has two blocks, intermediate point and end point; the second one is missing. Add \
         it, or give the centre."
            .to_owned(),
    );
}
