//! SPEC-06: the letters of the classification are not followed by three digits.

use crate::format::Classification;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "not-three-digits",
    title: "The letters of the classification are not followed by three digits.",
    verdicts: Verdicts::all("SPEC-06", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("C.2")],
    page: page!("SPEC-06"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) {
    // That nothing is written at all is said of the first letter.
    if found.digits().is_none() && !found.is_empty() {
        let range = match (found.rest.first(), found.rest.last()) {
            (Some(first), Some(last)) => first.1.start..last.1.end,
            _ => found.length..found.length,
        };
        sink.report(
            &RULE,
            range,
            "Exactly three digits follow the letters: motions, motions under dimension words, motions at a time, as in \
             CSM 432."
                .to_owned(),
        );
    }
}
