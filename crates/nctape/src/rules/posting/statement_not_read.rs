//! POST-09: a statement of CL text became no record.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "statement-not-read",
    title: "A statement of CL text became no record.",
    verdicts: Verdicts::all("POST-09", Severity::Error),
    clauses: &[],
    page: page!("POST-09"),
};
