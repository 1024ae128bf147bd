//! POST-07: blank tape is asked for, which the text of a tape cannot hold.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "leader-not-in-text",
    title: "Blank tape is asked for, which the text of a tape cannot hold.",
    verdicts: Verdicts::all("POST-07", Severity::Info),
    clauses: &[],
    page: page!("POST-07"),
};
