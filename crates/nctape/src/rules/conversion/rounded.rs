//! CONV-10: numbers are rounded to the places of the format that a tape is written for.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "rounded",
    title: "Numbers are rounded to the places of the format that a tape is written for.",
    verdicts: Verdicts::all("CONV-10", Severity::Info),
    clauses: &[],
    page: page!("CONV-10"),
};
