//! TAPE-05: a program start character in the program acts as a rewind stop.

use crate::read::StrayKind;
use crate::rules::prelude::*;
use std::ops::Range;

/// The rule.
pub static RULE: Rule = Rule {
    name: "program-start-inside",
    title: "A program start character in the program acts as a rewind stop.",
    verdicts: Verdicts::all("TAPE-05", Severity::Warning),
    clauses: &[Clause::Iso2539("B.2 note 3"), Clause::Iso1058("B.2 note 5")],
    page: page!("TAPE-05"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let last = tape.reading.blocks.iter().rposition(|block| !tape.reading.words(block).is_empty());
    for mark in tape.reading.programs() {
        // Between programs that each have their end it starts the next one; at the end of the tape it is never rewound
        // over.
        let behind = last.is_some_and(|last| last >= mark.blocks_before);
        if mark.word_before.is_some_and(|before| behind && !tape.ends_program(before..mark.blocks_before)) {
            report(mark.range.clone(), sink);
        }
    }
}

pub(crate) fn check_block(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for stray in block.strays.iter().filter(|stray| stray.kind == StrayKind::ProgramStart) {
        report(stray.range(), sink);
    }
}

fn report(range: Range<usize>, sink: &mut Sink<'_>) {
    sink.report(
        &RULE,
        range.clone(),
        "A program start % behind the first block is an absolute rewind stop: a tape that rewinds over it halts here \
         and not at its start. Take it out, unless that is meant."
            .to_owned(),
    )
    .fix(|| Fix::replace("Take it out", range, ""));
}
