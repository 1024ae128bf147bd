//! CONV-07: blocks behind the end of the program are left out.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unreached-left-out",
    title: "Blocks behind the end of the program are left out.",
    verdicts: Verdicts::all("CONV-07", Severity::Info),
    clauses: &[],
    page: page!("CONV-07"),
};
