//! NUM-21: a dimension word takes its axis beyond its travel.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "beyond-travel",
    title: "A dimension word takes its axis beyond its travel.",
    verdicts: Verdicts::all("NUM-21", Severity::Error),
    clauses: &[Clause::Iso2539("6"), Clause::Iso1058("4")],
    page: page!("NUM-21"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::OutOfTravel { word, at, travel: (least, most) } = event.kind else { return };
    let Some((range, word)) = tape.word(event.block, word) else { return };
    let places = usize::from(tape.control.designation(word.address).map_or(0, |designation| designation.after));
    let message = format!(
        "{} goes to {at:.places$}; the travel of the axis is {least} to {most} (travel). Correct the word, or the set \
         point.",
        word.letter()
    );
    sink.report(&RULE, range, message);
}
