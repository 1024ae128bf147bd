//! SEQ-01: a block has no sequence number word.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "missing-sequence-number",
    title: "A block has no sequence number word.",
    verdicts: Verdicts::contouring("SEQ-01", Severity::Error).rs274_as(Severity::Info),
    clauses: &[Clause::Iso2539("3.2.1.1")],
    page: page!("SEQ-01"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(first) = block.words.first() else { return };
    // Digits without an address at the head are probably the number: WORD-11. An O or H may be one that was mistyped.
    let named = matches!(first.address, b'H' | b'L' | b'O') && !is_declared(first, block.control);
    if first.address != 0 && !named && !block.words.iter().any(Word::is_sequence) {
        sink.report(
            &RULE,
            first.range(),
            "The block begins without a sequence number word. Put one first, such as N001.".to_owned(),
        );
    }
}
