//! CONV-05: skipping a block changes what follows on the tape, but not in the converted text.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "skip-is-fixed",
    title: "Skipping a block changes what follows on the tape, but not in the converted text.",
    verdicts: Verdicts::all("CONV-05", Severity::Warning),
    clauses: &[],
    page: page!("CONV-05"),
};
