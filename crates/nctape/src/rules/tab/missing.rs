//! TAB-04: in a system with tabs and addresses a word has no tab (ISO 1058).

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "word-without-tab",
    title: "In a system with tabs and addresses a word has no tab.",
    verdicts: Verdicts::positioning("TAB-04", Severity::Error),
    clauses: &[Clause::Iso1058("C.1.2")],
    page: page!("TAB-04"),
};

/// Said once, with how many words it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.control.system != System::TabAndAddress || !sink.asks(&RULE) {
        return;
    }
    // Digits without an address are reported for that: WORD-11.
    let mut bare = tape.words().filter(|(_, word)| !word.is_sequence() && word.address != 0 && word.tabs == 0);
    let Some((block, word)) = bare.next() else { return };
    let message = format!(
        "{} has no tab before it; in a system with tabs and addresses (S) ISO 1058 has one before every word but the \
         sequence number, and for every word left out before it. Put the tabs there.",
        word.letter()
    );
    sink.report(&RULE, tape.range(block, word), message).count(1 + bare.count());
}
