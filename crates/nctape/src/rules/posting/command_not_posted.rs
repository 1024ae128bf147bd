//! POST-02: a command is nothing that a tape of this format can say.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "command-not-posted",
    title: "A command is nothing that a tape of this format can say.",
    verdicts: Verdicts::all("POST-02", Severity::Error),
    clauses: &[],
    page: page!("POST-02"),
};
