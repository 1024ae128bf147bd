//! TAPE-01: no end of block stands before the first block.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "missing-leading-end-of-block",
    title: "No end of block stands before the first block.",
    verdicts: Verdicts::contouring("TAPE-01", Severity::Error).rs274_as(Severity::Info),
    clauses: &[Clause::Iso2539("3.2.1.3")],
    page: page!("TAPE-01"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    for index in tape.reading.unled() {
        let block = &tape.reading.blocks[index];
        // Behind a program without its end % starts no other one: TAPE-05.
        let before = (0..index).rfind(|&before| !tape.reading.words(&tape.reading.blocks[before]).is_empty());
        if before.is_some_and(|before| !tape.ends_program(before..index)) {
            continue;
        }
        // An end of block that stands before the program start character is there, but too early: TAPE-04.
        if before.is_none() && super::late_program_start::marks(tape).next().is_some() {
            continue;
        }
        let at = block.range.start;
        sink.report(
            &RULE,
            tape.extent(index),
            "The first block has no end of block before it; a control passes over everything up to the first end of \
             block. Put a line end or * before it."
                .to_owned(),
        )
        .fix(|| Fix::replace("Put an end of block before it", at..at, "\n"));
    }
}
