//! POST-01: the tool axis is tilted, and the tape has no axis that tilts it.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tilted-tool-axis",
    title: "The tool axis is tilted, and the tape has no axis that tilts it.",
    verdicts: Verdicts::all("POST-01", Severity::Error),
    clauses: &[Clause::Iso3592("3")],
    page: page!("POST-01"),
};
