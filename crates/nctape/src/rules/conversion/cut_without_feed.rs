//! CONV-04: a cut has no known feed: it is written with F0.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "cut-without-feed",
    title: "A cut has no known feed: it is written with F0.",
    verdicts: Verdicts::all("CONV-04", Severity::Error),
    clauses: &[],
    page: page!("CONV-04"),
};
