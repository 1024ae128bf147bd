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

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if word.address == b'O' {
        let at = word.range().start;
        let in_number = block.words.binary_search_by_key(&word.from, |before| before.to).is_ok();
        sink.report(
            &RULE,
            word.range(),
            "The letter O is not to be used as an address, lest it be taken for a zero. Write the digit 0 where one is \
             meant; otherwise take the word out."
                .to_owned(),
        )
        .fixes(in_number.then(|| Fix::replace("Write the digit 0", at..at + 1, "0")));
    }
}
