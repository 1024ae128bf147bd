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

pub(crate) fn check(word: &Word, sink: &mut Sink<'_>) {
    if word.address == b'O' {
        sink.report(
            &RULE,
            word.range(),
            "The letter O is not to be used as an address, lest it be taken for a zero. Take the word out, or write \
             another address."
                .to_owned(),
        );
    }
}

/// An O in a number, where a zero belongs.
pub(crate) fn check_block(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    super::letter_for_digit::report(&RULE, |letter| matches!(letter, 'O' | 'o'), '0', block, sink);
}
