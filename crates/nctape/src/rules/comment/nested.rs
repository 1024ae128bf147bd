//! CTRL-05: comments do not nest.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "nested-comment",
    title: "Comments do not nest.",
    verdicts: Verdicts::all("CTRL-05", Severity::Warning),
    clauses: &[Clause::Iso2539("B.2 note 4"), Clause::Iso1058("B.2 note 6")],
    page: page!("CTRL-05"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for stray in block.strays.iter().filter(|stray| stray.kind == StrayKind::NestedControlOut) {
        sink.report(
            &RULE,
            stray.range(),
            "A ( inside a comment has no meaning: the next ) ends the comment. Take it out.".to_owned(),
        );
    }
}
