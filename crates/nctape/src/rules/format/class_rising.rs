//! SPEC-07: the digits of the classification rise.

use crate::format::Classification;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "rising-motion-counts",
    title: "The digits of the classification rise.",
    verdicts: Verdicts::all("SPEC-07", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("C.2.1 to C.2.3")],
    page: page!("SPEC-07"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) {
    let Some([all, dimension, simultaneous]) = found.digits() else { return };
    if dimension > all || simultaneous > dimension {
        let range = found.rest[0].1.start..found.rest[2].1.end;
        let message = format!(
            "Of {all} motions {dimension} have dimension words and {simultaneous} move at a time; none of these counts \
             can be more than the one before it."
        );
        sink.report(&RULE, range, message);
    }
}
