//! SPEC-03: the second letter of the classification is not A, T or S.

use crate::format::Classification;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unknown-system",
    title: "The second letter of the classification is not A, T or S.",
    verdicts: Verdicts::all("SPEC-03", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("C.1.2")],
    page: page!("SPEC-03"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) -> bool {
    super::check_letter(&RULE, found, 1, &[('A', "addresses"), ('T', "tabs"), ('S', "addresses and tabs")], sink)
}
