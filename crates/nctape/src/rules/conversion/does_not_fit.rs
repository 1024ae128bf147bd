//! CONV-09: a number or a motion cannot be said in the format that a tape is written for.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "does-not-fit",
    title: "A number or a motion cannot be said in the format that a tape is written for.",
    verdicts: Verdicts::all("CONV-09", Severity::Error),
    clauses: &[],
    page: page!("CONV-09"),
};
