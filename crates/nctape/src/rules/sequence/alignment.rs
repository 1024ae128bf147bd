//! SEQ-10: the alignment function stands in place of N, not beside it.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "alignment-beside-sequence-number",
    title: "The alignment function stands in place of N, not beside it.",
    verdicts: Verdicts::all("SEQ-10", Severity::Error),
    clauses: &[Clause::Both("B.1 note 2")],
    page: page!("SEQ-10"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if both(block) {
        let second = block.words[1].range();
        sink.report(
            &RULE,
            second.clone(),
            "The alignment function : replaces N as the address of the sequence number; both in one block are wrong. \
             Keep one."
                .to_owned(),
        )
        .fix(|| Fix::replace("Take it out", second, ""));
    }
}

/// The block begins with both.
pub(crate) fn both(block: &BlockView<'_>) -> bool {
    matches!(block.words, [first, second, ..]
        if first.is_sequence() && second.is_sequence() && first.address != second.address)
}
