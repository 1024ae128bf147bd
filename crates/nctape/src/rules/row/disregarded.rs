//! ROW-04: a control disregards a row.

use crate::code::Code;
use crate::rules::prelude::{Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "disregarded-row",
    title: "A control disregards a row.",
    verdicts: Verdicts::all("ROW-04", Severity::Info),
    clauses: &[],
    page: page!("ROW-04"),
};

/// What is said of a row.
pub(crate) fn message(row: u8, code: Code) -> String {
    let name = code.meaning(row).map_or("row", |meaning| meaning.1);
    format!("The row is a {name}, which a control disregards: it is left out of the listing.")
}
