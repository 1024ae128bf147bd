//! TAPE-12: a block has no word.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "empty-block",
    title: "A block has no word.",
    verdicts: Verdicts::all("TAPE-12", Severity::Info),
    clauses: &[Clause::Both("3.2.1")],
    page: page!("TAPE-12"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if block.words.is_empty() && block.strays.is_empty() && block.skip.is_none() && block.end.is_some() {
        sink.report(
            &RULE,
            0..block.text.len(),
            "This block has no word: two ends of block follow one another. A control reads it and does nothing."
                .to_owned(),
        );
    }
}
