//! FUN-11: a lead stands for an axis that does not move.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "lead-of-a-still-axis",
    title: "A lead stands for an axis that does not move.",
    verdicts: Verdicts::contouring("FUN-11", Severity::Warning),
    clauses: &[Clause::Iso2539("B.1")],
    page: page!("FUN-11"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::IdleLead { word, axis } = event.kind else { return };
    let Some((range, word)) = tape.word(event.block, word) else { return };
    let message = format!(
        "{} is the lead of a thread along {}, which does not move in this block. Give the lead of the axis that does.",
        word.letter(),
        ["X", "Y", "Z"][axis]
    );
    sink.report(&RULE, range, message);
}
