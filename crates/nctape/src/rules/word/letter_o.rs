//! WORD-14: the letter O is not to be used.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "letter-o",
    title: "The letter O is not to be used.",
    verdicts: Verdicts::all("WORD-14", Severity::Error),
    clauses: &[Clause::Both("B.1")],
    page: page!("WORD-14"),
};

pub(crate) fn check(word: &Word, _: &BlockView<'_>, sink: &mut Sink<'_>) {
    if word.address == b'O' {
        sink.report(
            &RULE,
            word.range(),
            "The letter O is not to be used as an address, lest it be taken for a zero. Write the digit, or take the \
             word out."
                .to_owned(),
        );
    }
}
