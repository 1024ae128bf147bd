//! COMP-02: P, Q and R are axes of the format, and a vector on the tape.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "vector-read-as-axes",
    title: "P, Q and R are axes of the format, and a vector on the tape.",
    verdicts: Verdicts::contouring("COMP-02", Severity::Error),
    clauses: &[Clause::Iso2539("5"), Clause::Iso2539("B.1")],
    page: page!("COMP-02"),
};

/// Said once, with how many blocks it holds for: where they form a unit vector under G41 or G42. A tertiary motion
/// beside the compensation is no fault, and does not look like that but by chance.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let events = tape.execution.events.iter();
    let mut found = events.filter(|event| matches!(event.kind, EventKind::VectorAsAxes));
    let Some(event) = found.next() else { return };
    let message = "P, Q and R form a unit vector while G41 or G42 is in force, but the format has them as axes, which \
                   they move here. The addresses have one use only: state that they are the vector of cutter \
                   compensation, or take them out."
        .to_owned();
    let mut format = tape.control.format.clone();
    format.itemized.compensation = Some(true);
    let range = super::vector_words(tape, event.block);
    sink.report(&RULE, range, message)
        .count(1 + found.count())
        .fix(|| Fix::reformat("Read P, Q and R as the vector (compensation: true)", format));
}
