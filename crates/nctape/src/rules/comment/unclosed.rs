//! CTRL-01: a left parenthesis is never closed.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unclosed-comment",
    title: "A left parenthesis is never closed.",
    verdicts: Verdicts::all("CTRL-01", Severity::Error),
    clauses: &[Clause::Iso2539("B.2 note 4"), Clause::Iso1058("B.2 note 6")],
    page: page!("CTRL-01"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for stray in block.strays.iter().filter(|stray| stray.kind == StrayKind::Unclosed) {
        sink.report(
            &RULE,
            stray.range(),
            "The control out ( has no control in ) behind it: everything that follows is ignored. Close the comment."
                .to_owned(),
        )
        .fix(|| {
            let line = block.text[stray.range().end..].find(['\n', '\r', '*']);
            let at = line.map_or(block.text.len(), |line| stray.range().end + line);
            Fix::replace("Close it at the end of the line", at..at, ")")
        });
    }
}
