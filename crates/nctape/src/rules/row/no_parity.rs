//! ROW-07: the tape has no parity.

use crate::code::Code;
use crate::rules::prelude::{Clause, Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "tape-without-parity",
    title: "The tape has no parity.",
    verdicts: Verdicts::all("ROW-07", Severity::Warning),
    clauses: &[Clause::Both("1.5")],
    page: page!("ROW-07"),
};

/// What is said of the first row whose parity is wrong.
pub(crate) fn message(row: u8, code: Code) -> String {
    let how = if row & 0x80 == 0 { "never punched" } else { "punched in every row" };
    format!(
        "The row has {}. Track 8 of this tape is {how}, where {} makes the number of holes even with it: a lost hole \
         cannot be found, and a control that checks the parity stops here. If the reader took track 8 away, let it keep \
         it; otherwise punch the tape anew.",
        super::tracks(row),
        code.name()
    )
}
