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
    if word.tabs > 0 && block.control.system != System::Address {
        sink.report(
            &RULE,
            word.range(),
            "A tab stands before the sequence number word, which has none. Take the tab out.".to_owned(),
        );
    }
}
