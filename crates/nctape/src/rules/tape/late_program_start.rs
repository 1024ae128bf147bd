//! TAPE-04: the program start character stands behind the first end of block.

use crate::read::ProgramMark;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "late-program-start",
    title: "The program start character stands behind the first end of block.",
    verdicts: Verdicts::all("TAPE-04", Severity::Error),
    clauses: &[Clause::Iso2539("B.2 note 3"), Clause::Iso1058("B.2 note 5")],
    page: page!("TAPE-04"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    for mark in marks(tape) {
        sink.report(
            &RULE,
            mark.range.clone(),
            "The program start % stands behind the first end of block; it belongs before it. Move it to the very start \
             of the tape."
                .to_owned(),
        )
        .fix(|| {
            let moved = mark.range.start..mark.number.end;
            let insert = tape.text[moved.clone()].to_owned();
            // With an end of block behind it there would be two before the first block.
            let behind = tape.text[moved.end..].starts_with('\n');
            let gone = moved.start..moved.end + usize::from(behind);
            Fix::edits("Move it to the start", [(0..0, insert), (gone, String::new())])
        });
    }
}

/// The program start characters that stand before every word but behind an end of block.
pub(super) fn marks(tape: &TapeView<'_>) -> impl Iterator<Item = ProgramMark> {
    tape.reading.programs().filter(|mark| mark.behind_end_of_block && mark.word_before.is_none())
}
