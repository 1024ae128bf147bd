//! CONV-01: a motion is not converted: the tape does not say what it is, or the other control has nothing like it.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "span-not-converted",
    title: "A motion is not converted: the tape does not say what it is, or the other control has nothing like it.",
    verdicts: Verdicts::all("CONV-01", Severity::Error),
    clauses: &[],
    page: page!("CONV-01"),
};
