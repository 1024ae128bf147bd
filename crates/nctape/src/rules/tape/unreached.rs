//! TAPE-11: blocks behind the end of the program are never executed.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "blocks-behind-the-end",
    title: "Blocks behind the end of the program are never executed.",
    verdicts: Verdicts::all("TAPE-11", Severity::Warning),
    clauses: &[Clause::Iso1056("M02, M30")],
    page: page!("TAPE-11"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    // What the other position of the optional block skip switch executes is not lost: SKIP-03 speaks of it.
    let is_lost = |index: usize| tape.other.is_none_or(|other| other.unreached.binary_search(&index).is_ok());
    let has_words = |index: usize| !tape.reading.words(&tape.reading.blocks[index]).is_empty();
    let mut unreached = tape.execution.unreached.iter().filter(|&&index| has_words(index) && is_lost(index));
    let Some(&first) = unreached.next() else { return };
    sink.report(
        &RULE,
        tape.extent(first),
        "This block stands behind the end of the program (M02 or M30) and is never executed. Move the end code behind \
         it, or start another program with %."
            .to_owned(),
    )
    .count(1 + unreached.count());
}
