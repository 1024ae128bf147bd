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
    let known = word.address == 0
        || control.designation(word.address).is_some()
        || word.address == b':' && control.designation(b'N').is_some();
    if known || is_declared(word, control) || super::has_rule_of_its_own(word, control) {
        return;
    }
    let words: Vec<String> = control.detail.words.iter().map(|designation| designation.text()).collect();
    let message = if words.is_empty() {
        format!("The address {} is not in the format: its detail names no word at all.", word.letter())
    } else {
        format!("The address {} is not in the format, which has {}. Take the word out.", word.letter(), words.join(" "))
    };
    sink.report(&RULE, word.range(), message);
}
