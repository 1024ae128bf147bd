//! SKIP-02: a slash needs a sequence number word behind it.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "block-skip-without-sequence-number",
    title: "A slash needs a sequence number word behind it.",
    verdicts: Verdicts::positioning("SKIP-02", Severity::Error),
    clauses: &[Clause::Iso1058("B.2 note 4")],
    page: page!("SKIP-02"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(at) = block.skip else { return };
    // A sequence number word further back is a fault of its own: SEQ-07.
    if !block.words.iter().any(Word::is_sequence) {
        sink.report(
            &RULE,
            at..at + 1,
            "The optional block skip / must stand immediately before a sequence number word; this block has none. \
             Give it one, such as /N005."
                .to_owned(),
        );
    }
}
