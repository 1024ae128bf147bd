//! SPEC-02: the classification does not begin with P or L.

use crate::format::Classification;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "not-a-positioning-class",
    title: "The classification does not begin with P or L.",
    verdicts: Verdicts::positioning("SPEC-02", Severity::Error),
    clauses: &[Clause::Iso1058("C.1.1")],
    page: page!("SPEC-02"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) -> bool {
    super::check_letter(&RULE, found, 0, &[('P', "positioning"), ('L', "positioning and straight cuts")], sink)
}
