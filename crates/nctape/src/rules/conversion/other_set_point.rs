//! CONV-11: a tape begins where the other format does not.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "other-set-point",
    title: "A tape begins where the other format does not.",
    verdicts: Verdicts::all("CONV-11", Severity::Warning),
    clauses: &[],
    page: page!("CONV-11"),
};
