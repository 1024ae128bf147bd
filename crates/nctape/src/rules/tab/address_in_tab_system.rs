//! TAB-09: a system without addresses has none.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "address-in-tab-system",
    title: "A system without addresses has none.",
    verdicts: Verdicts::all("TAB-09", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("C.1.2")],
    page: page!("TAB-09"),
};

/// Said once, with how many words it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.control.system != System::Tab {
        return;
    }
    // The colon of an alignment function is what tells it from a sequence number. A letter that the format lacks, or
    // without digits, is reported for that.
    let written = |word: &Word| {
        let known = !word.by_column && tape.control.designation(word.address).is_some();
        known && word.address != b':' && word.fault != NumberFault::Empty
    };
    let found: Vec<usize> =
        tape.words().filter(|(_, word)| written(word)).map(|(block, word)| tape.range(block, word).start).collect();
    let Some(&first) = found.first() else { return };
    let message = format!(
        "The address {} is punched; in a system with tabulation and without addresses (T) the column tells the word. Take \
         the addresses out, or state a system with both (S).",
        tape.text[first..].chars().next().unwrap_or('?').to_ascii_uppercase()
    );
    sink.report(&RULE, first..first + 1, message)
        .count(found.len())
        .fix(|| Fix::edits("Take the addresses out", found.iter().map(|&at| (at..at + 1, String::new()))));
}
