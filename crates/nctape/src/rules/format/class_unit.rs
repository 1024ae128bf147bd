//! SPEC-04: the third letter of the classification is not M or I.

use crate::format::Classification;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unknown-unit",
    title: "The third letter of the classification is not M or I.",
    verdicts: Verdicts::all("SPEC-04", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("C.1.3")],
    page: page!("SPEC-04"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) -> bool {
    super::check_letter(&RULE, found, 2, &[('M', "millimetres"), ('I', "inches")], sink)
}
