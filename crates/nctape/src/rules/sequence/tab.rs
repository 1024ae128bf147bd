//! SEQ-06: the sequence number word has no tab.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tab-before-sequence-number",
    title: "The sequence number word has no tab.",
    verdicts: Verdicts::all("SEQ-06", Severity::Error),
    clauses: &[Clause::Both("3.3.2")],
    page: page!("SEQ-06"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(word) = block.sequence() else { return };
    if block.control.system == System::Address {
        return;
    }
    let before = &block.text[..word.range().start];
    let Some(at) = before.rfind('\t').filter(|_| word.tabs > 0) else { return };
    sink.report(
        &RULE,
        at..at + 1,
        "The tab before the sequence number word is one too many: this word has none. Take the tab out.".to_owned(),
    )
    .fix(|| Fix::edits("Take it out", before.match_indices('\t').map(|(at, _)| (at..at + 1, String::new()))));
}
