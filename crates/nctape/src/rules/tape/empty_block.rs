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
    // What a stray says is said by its own rule, unless it stands in a comment.
    let bare = block.strays.iter().all(|stray| stray.kind.is_in_comment());
    if block.words.is_empty() && bare && block.skip.is_none() && block.end.is_some() {
        sink.report(
            &RULE,
            0..block.text.len(),
            "The block has no word between two ends of block. A control reads it and does nothing.".to_owned(),
        );
    }
}
