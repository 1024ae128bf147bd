//! CTRL-02: a right parenthesis has no left one.

use crate::read::{Stray, StrayKind};
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
    // A ( inside the comment before it has led to this one: CTRL-05.
    if block.strays.iter().any(|stray| stray.kind == StrayKind::NestedControlOut) {
        return;
    }
    let before = std::iter::once(None).chain(block.strays.iter().map(Some));
    for (before, stray) in before.zip(block.strays).filter(|(_, stray)| stray.kind == StrayKind::ControlIn) {
        sink.report(
            &RULE,
            stray.range(),
            "The control in ) has no control out ( before it, so the control reads what was meant as a comment. Open the \
             comment, or take the ) out."
                .to_owned(),
        )
        .fix(|| {
            let lost = |other: &&Stray| other.kind == StrayKind::LostComment && other.to == stray.from;
            match before.filter(lost).map(|lost| lost.range().start) {
                Some(at) => Fix::replace("Open the comment", at..at, "("),
                None => Fix::replace("Take it out", stray.range(), ""),
            }
        });
    }
}
