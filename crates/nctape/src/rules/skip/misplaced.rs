//! SKIP-01: the slash does not stand before the sequence number word.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "misplaced-block-skip",
    title: "The slash does not stand before the sequence number word.",
    verdicts: Verdicts::all("SKIP-01", Severity::Error),
    clauses: &[Clause::Iso2539("B.2 note 2"), Clause::Iso1058("B.2 note 4")],
    page: page!("SKIP-01"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    // Under ISO 1058 SKIP-02 says that a sequence number word is missing.
    if let Some(at) = block.skip.filter(|_| block.words.is_empty() && block.control.standard() != Standard::Iso1058) {
        sink.report(
            &RULE,
            at..at + 1,
            "The optional block skip / stands alone: there is no block behind it to skip. Put it immediately before a \
             sequence number word, or take it out."
                .to_owned(),
        )
        .fix(|| Fix::replace("Take it out", at..at + 1, ""));
    }
    for stray in block.strays.iter().filter(|stray| stray.kind == StrayKind::Skip) {
        sink.report(
            &RULE,
            stray.range(),
            "The optional block skip / stands elsewhere than immediately before the sequence number word, at the head of \
             the block. Move it there."
                .to_owned(),
        )
        .fixes(block.sequence().filter(|_| block.skip.is_none()).map(|word| {
            let head = word.range().start;
            Fix::edits(
                "Move it to the head of the block",
                [(head..head, "/".to_owned()), (stray.range(), String::new())],
            )
        }));
    }
}
