//! MOT-20: a position is beyond what can be counted.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "position-overflow",
    title: "A position is beyond what can be counted.",
    verdicts: Verdicts::all("MOT-20", Severity::Error),
    clauses: &[],
    page: page!("MOT-20"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Overflow { word } = event.kind else { return };
    let block = &tape.reading.blocks[event.block];
    let Some(word) = tape.reading.words(block).get(word) else { return };
    let message = format!(
        "{} takes its axis beyond the largest position that can be counted; the word is left out. Correct its digits \
         or the set point.",
        word.letter()
    );
    sink.report(&RULE, tape.reading.range(block, word), message);
}
