//! FUN-02: a permanently unassigned function is not declared.

use crate::function::{Miscellaneous, Preparatory, miscellaneous, preparatory};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "undeclared-function",
    title: "A permanently unassigned function is not declared.",
    verdicts: Verdicts::all("FUN-02", Severity::Warning),
    clauses: &[Clause::Iso1056("tables of G and M")],
    page: page!("FUN-02"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let found = match (word.function(b'G'), word.function(b'M')) {
        (Some(code), _) if preparatory(code) == Preparatory::PermanentlyUnassigned => ('G', code),
        (_, Some(code)) if miscellaneous(code) == Miscellaneous::PermanentlyUnassigned => ('M', code),
        _ => return,
    };
    let (letter, code) = found;
    if word.digits == 2 && !super::is_declared(letter, code, block.control) {
        let message = format!(
            "{letter}{code:02} is permanently unassigned, left to the builder of the control; the itemized data does not \
             say what it means here. Declare it.{}",
            super::conflict(letter, code)
        );
        sink.report(&RULE, word.range(), message);
    }
}
