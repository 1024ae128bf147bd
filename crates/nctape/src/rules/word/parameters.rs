//! WORD-15: I, J and K are unassigned in ISO 1058.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "undeclared-parameter",
    title: "I, J and K are unassigned in ISO 1058.",
    verdicts: Verdicts::positioning("WORD-15", Severity::Error),
    clauses: &[Clause::Iso1058("B.1")],
    page: page!("WORD-15"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if matches!(word.address, b'I' | b'J' | b'K') && !is_declared(word, block.control) {
        let message = format!(
            "{} is unassigned in ISO 1058: it means something only where the itemized data declares it. Declare it, or \
             take the word out.",
            word.letter()
        );
        sink.report(&RULE, word.range(), message);
    }
}
