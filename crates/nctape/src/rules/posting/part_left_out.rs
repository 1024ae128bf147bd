//! POST-04: a command is posted in part, or passed over.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "part-left-out",
    title: "A command is posted in part, or passed over.",
    verdicts: Verdicts::all("POST-04", Severity::Warning),
    clauses: &[],
    page: page!("POST-04"),
};
