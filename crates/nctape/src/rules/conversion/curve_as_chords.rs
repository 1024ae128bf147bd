//! CONV-08: a curve is written as straight cuts within a tolerance.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "curve-as-chords",
    title: "A curve is written as straight cuts within a tolerance.",
    verdicts: Verdicts::contouring("CONV-08", Severity::Info),
    clauses: &[],
    page: page!("CONV-08"),
};
