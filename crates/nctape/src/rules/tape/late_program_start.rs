//! TAPE-04: the program start character stands behind the first end of block.

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
    for mark in &tape.reading.programs {
        if mark.behind_end_of_block && mark.blocks_before == 0 {
            sink.report(
                &RULE,
                mark.range.clone(),
                "The program start % stands behind the first end of block; it belongs before it. Move it to the very \
                 start of the tape."
                    .to_owned(),
            );
        }
    }
}
