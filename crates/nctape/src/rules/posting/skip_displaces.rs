//! POST-08: blocks that may be skipped move the tool, and the dimensions are incremental.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "skip-displaces-what-follows",
    title: "Blocks that may be skipped move the tool, and the dimensions are incremental.",
    verdicts: Verdicts::all("POST-08", Severity::Warning),
    clauses: &[],
    page: page!("POST-08"),
};
