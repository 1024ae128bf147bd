//! CONV-03: a word is left out: the other control has none like it.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "word-left-out",
    title: "A word is left out: the other control has none like it.",
    verdicts: Verdicts::all("CONV-03", Severity::Warning),
    clauses: &[],
    page: page!("CONV-03"),
};
