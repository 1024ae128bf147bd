//! SPEC-01: the classification does not begin with C.

use crate::format::Classification;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "not-a-contouring-class",
    title: "The classification does not begin with C.",
    verdicts: Verdicts::contouring("SPEC-01", Severity::Error).not_rs274(),
    clauses: &[Clause::Iso2539("C.1.1")],
    page: page!("SPEC-01"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) -> bool {
    super::check_letter(&RULE, found, 0, &[('C', "contouring and positioning")], sink)
}
