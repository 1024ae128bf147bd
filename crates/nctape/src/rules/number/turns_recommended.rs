//! NUM-19: ISO 1058 recommends turns for angles.

use crate::format::{Angles, Classification};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "degrees-where-turns-are-recommended",
    title: "ISO 1058 recommends turns for angles.",
    verdicts: Verdicts::positioning("NUM-19", Severity::Info),
    clauses: &[Clause::Iso1058("3.3.3.2.2")],
    page: page!("NUM-19"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) {
    if let (Some(Angles::Degrees), Some((_, range))) = (found.angles(), found.letters.get(3)) {
        let message = "D: angles are in degrees, which is allowed; ISO 1058 recommends decimal parts of a turn (R).";
        sink.report(&RULE, range.clone(), message.to_owned());
    }
}
