//! SEQ-07: the sequence number word is not the first word of its block.

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
    let first = block.sequence().map_or(0, |_| 1);
    for word in block.words.iter().skip(first).filter(|word| word.is_sequence()) {
        // Two of them at the head are an alignment function and a number: a rule of its own.
        if super::alignment::both(block) {
            return;
        }
        sink.report(
            &RULE,
            word.range(),
            format!("The sequence number word {} is not the first word of its block. Put it first.", word.letter()),
        );
    }
}
