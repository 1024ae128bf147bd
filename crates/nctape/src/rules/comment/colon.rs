//! CTRL-03: a comment within the program holds a colon.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "colon-in-comment",
    title: "A comment within the program holds a colon.",
    verdicts: Verdicts::all("CTRL-03", Severity::Error),
    clauses: &[Clause::Iso2539("B.2 note 4"), Clause::Iso1058("B.2 note 6")],
    page: page!("CTRL-03"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for stray in super::strays(block).filter(|stray| stray.kind == StrayKind::Reserved(':')) {
        sink.report(
            &RULE,
            stray.range(),
            "A comment within the program must not hold : because a control that searches for the alignment function stops at \
             it. Write the comment without it."
                .to_owned(),
        )
        .fix(|| Fix::replace("Take it out", stray.range(), ""));
    }
}
