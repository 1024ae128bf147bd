//! TAPE-05: a program start character in the program acts as a rewind stop.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "program-start-inside",
    title: "A program start character in the program acts as a rewind stop.",
    verdicts: Verdicts::all("TAPE-05", Severity::Warning),
    clauses: &[Clause::Iso2539("B.2 note 3"), Clause::Iso1058("B.2 note 5")],
    page: page!("TAPE-05"),
};

const MESSAGE: &str = "A % behind the first block is an absolute rewind stop: a rewinding tape halts here and not at \
     its start. Take it out, unless that is meant.";

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    for mark in &tape.reading.programs {
        let blocks = &tape.reading.blocks;
        // At the end of the tape, and between programs that each have their end, it is where it belongs.
        let ended = tape.execution.ends.iter().any(|&(last, ended)| ended && last + 1 == mark.blocks_before);
        if mark.blocks_before > 0 && mark.blocks_before < blocks.len() && !ended {
            sink.report(&RULE, mark.range.clone(), MESSAGE.to_owned());
        }
    }
}

pub(crate) fn check_block(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for stray in block.strays.iter().filter(|stray| stray.kind == StrayKind::ProgramStart) {
        sink.report(&RULE, stray.range(), MESSAGE.to_owned());
    }
}
