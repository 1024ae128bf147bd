//! CTRL-02: a right parenthesis has no left one.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unopened-comment",
    title: "A right parenthesis has no left one.",
    verdicts: Verdicts::all("CTRL-02", Severity::Error),
    clauses: &[Clause::Iso2539("B.2 note 4"), Clause::Iso1058("B.2 note 6")],
    page: page!("CTRL-02"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for stray in block.strays.iter().filter(|stray| stray.kind == StrayKind::ControlIn) {
        sink.report(
            &RULE,
            stray.range(),
            "The control in ) has no control out ( before it. Take it out, or open the comment.".to_owned(),
        );
    }
}
