//! COMP-01: P, Q and R are no unit vector.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "compensation-vector-length",
    title: "P, Q and R are no unit vector.",
    verdicts: Verdicts::contouring("COMP-01", Severity::Error),
    clauses: &[Clause::Iso2539("5")],
    page: page!("COMP-01"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::VectorLength { length } = event.kind else { return };
    let message = if length == 0.0 {
        "P, Q and R are all zero: a vector of cutter compensation has a direction and the length 1. Give the direction, \
         or cancel the compensation with G40."
            .to_owned()
    } else {
        format!(
            "P, Q and R are the unit vector of cutter compensation; their length is {length:.3}, not 1. Correct them."
        )
    };
    sink.report(&RULE, super::vector_words(tape, event.block), message);
}
