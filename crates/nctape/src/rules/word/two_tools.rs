//! WORD-09: a block has more than one tool word.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "second-tool-word",
    title: "A block has more than one tool word.",
    verdicts: Verdicts::positioning("WORD-09", Severity::Warning),
    clauses: &[Clause::Iso1058("3.2.2.5")],
    page: page!("WORD-09"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for word in block.words.iter().filter(|word| word.address == b'T').skip(1) {
        sink.report(
            &RULE,
            word.range(),
            "T is a second tool function in this block; ISO 1058 foresees one. Put it into a block of its own."
                .to_owned(),
        );
    }
}
