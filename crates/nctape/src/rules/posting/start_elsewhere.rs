//! POST-05: the text begins elsewhere than the set point of the format.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "start-off-the-set-point",
    title: "The text begins elsewhere than the set point of the format.",
    verdicts: Verdicts::all("POST-05", Severity::Warning),
    clauses: &[],
    page: page!("POST-05"),
};
