//! TAB-06: a tab stands behind the address.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tab-behind-address",
    title: "A tab stands behind the address instead of before it.",
    verdicts: Verdicts::all("TAB-06", Severity::Error),
    clauses: &[Clause::Both("3.3.2")],
    page: page!("TAB-06"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    // A system without tabs has no place for them at all: TAB-01.
    if block.control.system == System::Address {
        return;
    }
    for stray in block.strays.iter().filter(|stray| stray.kind == StrayKind::TabBehindAddress) {
        let tab = stray.range();
        let Some(word) = block.word_at(tab.start) else { continue };
        let message = format!(
            "The tab stands between {} and its digits; it is the first character of a word, the address follows it. Take \
             it out, or move it before the address.",
            word.letter()
        );
        let at = word.range().start;
        let fix = match word.tabs {
            0 => Fix::edits("Move it before the address", [(at..at, "\t".to_owned()), (tab.clone(), String::new())]),
            _ => Fix::replace("Take it out", tab.clone(), ""),
        };
        sink.report(&RULE, tab, message).fix(|| fix);
    }
}
