//! ROW-06: rows outside the program are no characters.

use crate::code::Code;
use crate::rules::prelude::{Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "unreadable-outside-program",
    title: "Rows outside the program are no characters.",
    verdicts: Verdicts::all("ROW-06", Severity::Info),
    clauses: &[],
    page: page!("ROW-06"),
};

/// What is said of the first row of a stretch.
pub(crate) fn message(_: u8, code: Code) -> String {
    format!(
        "From here rows are no characters of {}. They stand before the first or behind the last end of block, where a \
         control passes over them: a label that a person reads, or damage. They are left out of the listing.",
        code.name()
    )
}
