//! CONV-04: a cut has no known feed: it is written so that the control stops.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "cut-without-feed",
    title: "A cut has no known feed: it is written so that the control stops.",
    verdicts: Verdicts::all("CONV-04", Severity::Error),
    clauses: &[],
    page: page!("CONV-04"),
};
