//! FUN-01: a preparatory function is not assigned.

use crate::function::{Preparatory, preparatory};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unassigned-preparatory-function",
    title: "A preparatory function is not assigned.",
    verdicts: Verdicts::all("FUN-01", Severity::Error),
    clauses: &[Clause::Iso1056("table of G")],
    page: page!("FUN-01"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(code) = word.function(b'G') else { return };
    if word.digits == 2 && preparatory(code) == Preparatory::Unassigned && !super::is_declared('G', code, block.control)
    {
        let message = format!(
            "G{code:02} is not assigned: it means something only where the itemized data declares it. Declare it, or \
             take the word out.{}",
            super::conflict('G', code)
        );
        sink.report(&RULE, word.range(), message);
    }
}
