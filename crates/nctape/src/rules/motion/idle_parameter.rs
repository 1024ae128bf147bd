//! MOT-16: I, J and K have no use here.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "idle-parameter",
    title: "I, J and K have no use here.",
    verdicts: Verdicts::contouring("MOT-16", Severity::Warning),
    clauses: &[Clause::Iso2539("4.1.3")],
    page: page!("MOT-16"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::IdleParameter { word, code } = event.kind else { return };
    let block = &tape.reading.blocks[event.block];
    let Some(word) = tape.reading.words(block).get(word) else { return };
    if is_declared(word, tape.control) {
        return;
    }
    let message = format!(
        "{} is an interpolation parameter; under G{code:02} it has no use. Take it out, or give the function that it \
         belongs to.",
        word.letter()
    );
    sink.report(&RULE, tape.reading.range(block, word), message);
}
