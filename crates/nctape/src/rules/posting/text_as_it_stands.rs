//! POST-06: a text goes to the tape as it stands, and is not followed.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "text-as-it-stands",
    title: "A text goes to the tape as it stands, and is not followed.",
    verdicts: Verdicts::all("POST-06", Severity::Info),
    clauses: &[],
    page: page!("POST-06"),
};
