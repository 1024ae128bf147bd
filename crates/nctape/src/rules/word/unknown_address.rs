//! WORD-12: an address is not in the format detail.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "address-not-in-format",
    title: "An address is not in the format detail.",
    verdicts: Verdicts::all("WORD-12", Severity::Error),
    clauses: &[Clause::Both("D.3")],
    page: page!("WORD-12"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let control = block.control;
    if word.address == 0 || super::is_known(word, control) || super::has_rule_of_its_own(word, control) {
        return;
    }
    let words: Vec<String> = control.detail.words.iter().map(|designation| designation.text()).collect();
    let message = if words.is_empty() {
        format!("The address {} is not in the format: its detail names no word at all.", word.letter())
    } else {
        format!(
            "The address {} is not in the format, which has {}. Take the word out, or state it in the detail.",
            word.letter(),
            words.join(" ")
        )
    };
    sink.report(&RULE, word.range(), message);
}
