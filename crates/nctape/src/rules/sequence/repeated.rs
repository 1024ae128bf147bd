//! SEQ-08: a sequence number occurs twice.

use crate::rules::prelude::*;
use std::collections::HashMap;

/// The rule.
pub static RULE: Rule = Rule {
    name: "repeated-sequence-number",
    title: "A sequence number occurs twice.",
    verdicts: Verdicts::all("SEQ-08", Severity::Warning),
    clauses: &[],
    page: page!("SEQ-08"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut seen: HashMap<(u32, i64), usize> = HashMap::new();
    let mut found = tape.sequence_numbers().filter_map(|(block, number)| {
        let program = tape.reading.blocks[block].program;
        let first = *seen.entry((program, number)).or_insert(block);
        (first != block).then_some((block, first))
    });
    let Some((block, first)) = found.next() else { return };
    let count = 1 + found.count();
    let range = tape.sequence_range(block);
    let message = format!(
        "The sequence number {} stands in an earlier block too: a search stops at that one. Number the blocks anew.",
        &tape.text[range.clone()]
    );
    sink.report(&RULE, range, message).count(count).related(tape.sequence_range(first), "the same sequence number");
}
