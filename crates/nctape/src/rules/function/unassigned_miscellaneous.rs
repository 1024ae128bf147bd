//! FUN-06: a miscellaneous function is not assigned.

use crate::function::{Miscellaneous, miscellaneous};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unassigned-miscellaneous-function",
    title: "A miscellaneous function is not assigned.",
    verdicts: Verdicts::all("FUN-06", Severity::Error),
    clauses: &[Clause::Iso1056("table of M")],
    page: page!("FUN-06"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(code) = word.function(b'M') else { return };
    let unassigned = miscellaneous(code) == Miscellaneous::Unassigned;
    if word.digits == 2 && unassigned && !super::is_declared('M', code, block.control) {
        let message = format!(
            "M{code:02} is not assigned: it means something only where the itemized data declares it. Declare it, or \
             take the word out.{}",
            super::conflict('M', code)
        );
        sink.report(&RULE, word.range(), message);
    }
}
