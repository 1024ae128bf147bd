//! WORD-07: a block has more than one miscellaneous function.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "second-miscellaneous-word",
    title: "A block has more than one miscellaneous function.",
    verdicts: Verdicts::contouring("WORD-07", Severity::Error),
    clauses: &[Clause::Iso2539("3.2.2.6")],
    page: page!("WORD-07"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for word in block.words.iter().filter(|word| word.address == b'M').skip(1) {
        sink.report(
            &RULE,
            word.range(),
            "M is a second miscellaneous function in this block, which has room for one. Put it into a block of its own.".to_owned(),
        );
    }
}
