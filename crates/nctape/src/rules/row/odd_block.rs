//! ROW-05: a block has an odd number of characters.

use crate::code::Code;
use crate::rules::prelude::{Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "odd-block",
    title: "A block has an odd number of characters.",
    verdicts: Verdicts::all("ROW-05", Severity::Warning),
    clauses: &[],
    page: page!("ROW-05"),
};

/// What is said of the end of a block.
pub(crate) fn message(_: u8, _: Code) -> String {
    "The characters of this block, end of block included, are odd in number: a control that counts them (TV) stops \
     here. A space before the end of block makes them even."
        .to_owned()
}
