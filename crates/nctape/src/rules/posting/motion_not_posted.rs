//! POST-03: a motion is not posted: where it goes is not known.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-not-posted",
    title: "A motion is not posted: where it goes is not known.",
    verdicts: Verdicts::all("POST-03", Severity::Error),
    clauses: &[],
    page: page!("POST-03"),
};
