//! FUN-10: a thread has no lead.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "thread-without-lead",
    title: "A thread has no lead along the axis that moves.",
    verdicts: Verdicts::contouring("FUN-10", Severity::Error),
    clauses: &[Clause::Iso2539("B.1"), Clause::Iso1056("table of G")],
    page: page!("FUN-10"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::NoLead { axis } = event.kind else { return };
    let (letter, moved) = (["I", "J", "K"][axis], ["X", "Y", "Z"][axis]);
    let message = format!(
        "The block cuts a thread along {moved}, but no lead was given for it, or it is zero. Give it as {letter}, the way \
         along {moved} with each revolution of the spindle."
    );
    sink.report(&RULE, tape.extent(event.block), message);
}
