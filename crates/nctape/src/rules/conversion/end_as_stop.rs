//! CONV-06: an end of program before another program is written as a stop.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "end-as-stop",
    title: "An end of program before another program is written as a stop.",
    verdicts: Verdicts::all("CONV-06", Severity::Warning),
    clauses: &[],
    page: page!("CONV-06"),
};
