//! SEQ-09: sequence numbers do not rise.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "falling-sequence-number",
    title: "Sequence numbers do not rise.",
    verdicts: Verdicts::all("SEQ-09", Severity::Info),
    clauses: &[],
    page: page!("SEQ-09"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.reading.survey().rises {
        return;
    }
    let mut before: Option<(u32, i64)> = None;
    let mut found = tape.sequence_numbers().filter(|&(block, number)| {
        let program = tape.reading.blocks[block].program;
        let falls = before.is_some_and(|(last_program, last)| last_program == program && number < last);
        before = Some((program, number));
        falls
    });
    let Some((block, _)) = found.next() else { return };
    let count = 1 + found.count();
    sink.report(
        &RULE,
        tape.sequence_range(block),
        "The sequence number is lower than the one before it. Nothing forbids it; usually they rise.".to_owned(),
    )
    .count(count);
}
