//! FUN-05: motion stands before any interpolation code.

use crate::execute::EventKind;
use crate::rules::prelude::*;
use crate::rules::word::no_address;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-without-interpolation",
    title: "Motion stands before any interpolation code.",
    verdicts: Verdicts::contouring("FUN-05", Severity::Warning).rs274_as(Severity::Info),
    clauses: &[Clause::Iso2539("4.2.1 a")],
    page: page!("FUN-05"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let events = tape.execution.events.iter();
    let mut found = events.filter(|event| matches!(event.kind, EventKind::NoInterpolation { lost: false }));
    let Some(event) = found.next() else { return };
    let block = &tape.reading.blocks[event.block];
    let words = tape.reading.words(block);
    let run_in = |word| no_address::run_into_number(word, words, &tape.text[block.range.clone()], tape.control);
    // Its code ran into the sequence number: WORD-11.
    if words.first().and_then(run_in).is_some() {
        return;
    }
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The block moves before any G00, G01, G02, G03 or G06 was given; it is read as G01. Put the function before it."
            .to_owned(),
    )
    .count(1 + found.count());
}
