//! MOT-02: an arc does not lie in a principal plane.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "arc-out-of-plane",
    title: "An arc does not lie in a principal plane.",
    verdicts: Verdicts::contouring("MOT-02", Severity::Error),
    clauses: &[Clause::Iso2539("4.2.2")],
    page: page!("MOT-02"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let word = match event.kind {
        EventKind::OutOfPlane { word } => Some(word),
        EventKind::ThirdAxisMoves => None,
        _ => return,
    };
    let block = &tape.reading.blocks[event.block];
    let (range, what) = match word.and_then(|word| tape.reading.words(block).get(word)) {
        Some(word) => {
            let what = match word.letter() {
                letter @ ('I' | 'J' | 'K') => format!("{letter} belongs to the third axis of the plane"),
                letter => format!("{letter} moves the third axis of the plane"),
            };
            (tape.reading.range(block, word), what)
        }
        None => (tape.extent(event.block), "The third axis of the plane moves".to_owned()),
    };
    let message = format!(
        "{what}; an arc lies in the plane that G17, G18 or G19 selected. Take the word out, or select the plane that \
         the arc lies in."
    );
    sink.report(&RULE, range, message);
}
