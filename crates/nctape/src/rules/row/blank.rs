//! ROW-03: a row within the program is blank.

use crate::code::Code;
use crate::rules::prelude::{Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "blank-within-program",
    title: "A row within the program is blank.",
    verdicts: Verdicts::all("ROW-03", Severity::Error),
    clauses: &[],
    page: page!("ROW-03"),
};

/// What is said of a row.
pub(crate) fn message(_: u8, code: Code) -> String {
    format!(
        "The row is blank; between the first and the last end of block {} has no blank tape. Punch a delete there, or \
         splice the tape.",
        code.name()
    )
}
