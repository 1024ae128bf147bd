//! WORD-13: H and L are permanently unassigned.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unassigned-address",
    title: "H and L are permanently unassigned.",
    verdicts: Verdicts::all("WORD-13", Severity::Error),
    clauses: &[Clause::Both("B.1")],
    page: page!("WORD-13"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if matches!(word.address, b'H' | b'L') && !is_declared(word, block.control) {
        let message = format!(
            "{} is permanently unassigned: it means something only where the itemized data declares it. Declare it, or \
             take the word out.",
            word.letter()
        );
        sink.report(&RULE, word.range(), message);
    }
}
