//! ROW-02: a row is no character of the code.

use crate::code::Code;
use crate::rules::prelude::{Clause, Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "unknown-row",
    title: "A row is no character of the code.",
    verdicts: Verdicts::all("ROW-02", Severity::Error),
    clauses: &[Clause::Both("1.5")],
    page: page!("ROW-02"),
};

/// What is said of a row.
pub(crate) fn message(row: u8, code: Code) -> String {
    format!("The row has {}; {} has no such character. Punch the one that was meant.", super::tracks(row), code.name())
}
