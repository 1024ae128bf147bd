//! TAPE-03: the last block has no end of block.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "missing-end-of-block",
    title: "The last block has no end of block.",
    verdicts: Verdicts::all("TAPE-03", Severity::Error),
    clauses: &[Clause::Both("3.2.1.3")],
    page: page!("TAPE-03"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let (None, Some(last)) = (block.end, block.words.last()) else { return };
    // An open comment has swallowed it: CTRL-01.
    if block.strays.iter().any(|stray| stray.kind == StrayKind::Unclosed) {
        return;
    }
    let at = block.text.len();
    sink.report(
        &RULE,
        last.range(),
        "The last block does not end with an end of block, so a control would not execute it. Put a line end or * \
         behind it."
            .to_owned(),
    )
    .fix(|| Fix::replace("Put an end of block behind it", at..at, "\n"));
}
