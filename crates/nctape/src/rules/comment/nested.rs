//! CTRL-05: comments do not nest.

use crate::read::StrayKind;
use crate::rules::prelude::*;
use std::ops::Range;

/// The rule.
pub static RULE: Rule = Rule {
    name: "nested-comment",
    title: "Comments do not nest.",
    verdicts: Verdicts::all("CTRL-05", Severity::Warning),
    clauses: &[Clause::Iso2539("B.2 note 4"), Clause::Iso1058("B.2 note 6")],
    page: page!("CTRL-05"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    // Where a comment has swallowed blocks, their comments are nested in it: CTRL-06.
    let mut nested = super::strays(block).filter(|stray| stray.kind == StrayKind::NestedControlOut).peekable();
    if nested.peek().is_none() {
        return;
    }
    let swallowed = super::swallowed::places(block);
    let is_swallowed = |at: usize| {
        let behind = swallowed.partition_point(|place| place.start < at);
        behind > 0 && at < swallowed[behind - 1].end
    };
    for (index, stray) in nested.filter(|stray| !is_swallowed(stray.range().start)).enumerate() {
        let range = stray.range();
        sink.report(
            &RULE,
            range.clone(),
            "Comments do not nest: a control out ( inside a comment has no meaning, and the next ) ends the comment. \
             Take it out."
                .to_owned(),
        )
        .fixes((index == 0).then(|| without(range, block)));
    }
}

/// Takes a control out out, and the control in that was meant for it where that ends the comment too early.
fn without(range: Range<usize>, block: &BlockView<'_>) -> Fix {
    let too_early = block.strays.iter().any(|stray| stray.kind == StrayKind::ControlIn);
    let control_in = block.text[range.end..].find(')').map(|at| range.end + at);
    let control_in = control_in.filter(|_| too_early).map(|at| at..at + 1);
    Fix::edits("Take it out", std::iter::once(range).chain(control_in).map(|range| (range, String::new())))
}
