//! SEQ-08: a sequence number occurs twice.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "repeated-sequence-number",
    title: "A sequence number occurs twice.",
    verdicts: Verdicts::all("SEQ-08", Severity::Warning),
    clauses: &[],
    page: page!("SEQ-08"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.reading.survey().rises {
        return;
    }
    let program = |block: usize| tape.reading.blocks[block].program;
    let numbers = tape.sequence_numbers().map(|(block, number)| ((program(block), number), block));
    let mut numbers: Vec<((u32, i64), usize)> = numbers.collect();
    numbers.sort_by_key(|it| it.0);
    let twins = numbers.chunk_by(|one, next| one.0 == next.0).filter(|twins| twins.len() > 1);
    let (count, repeated) = twins.fold((0, None::<(usize, usize)>), |(count, repeated), twins| {
        let this = (twins[1].1, twins[0].1);
        (count + twins.len() - 1, Some(repeated.map_or(this, |other| other.min(this))))
    });
    let Some((block, first)) = repeated else { return };
    let range = tape.sequence_range(block);
    let message = format!(
        "The sequence number {} stands in an earlier block too: a search stops at that one. Number the blocks anew.",
        &tape.text[range.clone()]
    );
    sink.report(&RULE, range, message).count(count).related(tape.sequence_range(first), "the same sequence number");
}
