//! SEQ-07: the sequence number word is not the first word of its block.

use crate::rules::comment;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "sequence-number-not-first",
    title: "The sequence number word is not the first word of its block.",
    verdicts: Verdicts::all("SEQ-07", Severity::Error),
    clauses: &[Clause::Both("3.2.1")],
    page: page!("SEQ-07"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    // Two of them at the head are an alignment function and a number: a rule of its own.
    if super::alignment::both(block) {
        return;
    }
    let headed = block.sequence().is_some();
    let others = block.words.iter().skip(usize::from(headed)).filter(|word| word.is_sequence());
    let mut others = others.peekable();
    // A comment that ran over a line end has joined the block of the second one to this one: CTRL-06.
    if others.peek().is_some() && comment::swallowed::joins(block) {
        return;
    }
    for (index, word) in others.enumerate() {
        let letter = word.letter();
        if headed || index > 0 {
            let message = format!("The sequence number word {letter} is a second one in its block. Take it out.");
            sink.report(&RULE, word.range(), message).fix(|| Fix::replace("Take it out", word.range(), ""));
        } else {
            let message =
                format!("The sequence number word {letter} is not the first word of its block. Put it first.");
            sink.report(&RULE, word.range(), message).fixes(move_before(word, &block.words[0], block));
        }
    }
}
