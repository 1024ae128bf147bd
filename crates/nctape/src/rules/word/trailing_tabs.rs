//! WORD-22: tabs stand behind the last word of a block.

use crate::rules::prelude::*;
use crate::rules::tab;

/// The rule.
pub static RULE: Rule = Rule {
    name: "trailing-tabs",
    title: "Tabs stand behind the last word of a block.",
    verdicts: Verdicts::all("WORD-22", Severity::Info),
    clauses: &[Clause::Both("3.2.4")],
    page: page!("WORD-22"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(last) = block.words.last().filter(|_| block.control.system != System::Address) else { return };
    // More tabs than the format has words are a fault: TAB-03.
    if tab::too_many::surplus(block).is_some() {
        return;
    }
    let mut tabs = tab::tabs(block);
    tabs.retain(|&at| at >= last.range().end);
    let (Some(&from), Some(&to)) = (tabs.first(), tabs.last()) else { return };
    sink.report(
        &RULE,
        from..to + 1,
        "The tabs behind the last word begin no word: the end of block may stand right behind it. Leave them out to save \
         tape."
            .to_owned(),
    )
    .fix(|| Fix::edits("Take them out", tabs.iter().map(|&at| (at..at + 1, String::new()))));
}
