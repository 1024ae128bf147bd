//! CONV-02: a function is left out: the other control has none that does the same.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "function-left-out",
    title: "A function is left out: the other control has none that does the same.",
    verdicts: Verdicts::all("CONV-02", Severity::Warning),
    clauses: &[],
    page: page!("CONV-02"),
};
