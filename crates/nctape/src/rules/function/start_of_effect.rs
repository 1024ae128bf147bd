//! FUN-07: a function acts at another moment than its block suggests.

use crate::execute::ends_program;
use crate::function::{Miscellaneous, Start, miscellaneous};
use crate::rules::prelude::*;
use crate::span::SpanKind;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unexpected-start-of-effect",
    title: "A function acts at another moment than its block suggests.",
    verdicts: Verdicts::all("FUN-07", Severity::Info),
    clauses: &[Clause::Iso1056("table of M")],
    page: page!("FUN-07"),
};

/// Said once for each function, and only where the moment matters: where the block cuts with what is to be switched
/// off, or moves at all under a function whose moment nothing states. Anything more would be a note on most tapes.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let (mut turns, mut flows) = (false, false);
    let mut said: Vec<(u8, usize, usize, usize)> = Vec::new();
    for &index in &tape.execution.miscellaneous {
        let words = tape.reading.words(&tape.reading.blocks[index]);
        for (place, word) in words.iter().enumerate() {
            let Some(code) = word.function(b'M').filter(|_| word.digits == 2) else { continue };
            let matters = match code {
                5 | 19 => turns && cuts(tape, index),
                9 => flows && cuts(tape, index),
                _ => is_open(code) && !super::is_declared('M', code, tape.control) && moves(tape, index),
            };
            if matters {
                match said.iter_mut().find(|(other, ..)| *other == code) {
                    Some((.., count)) => *count += 1,
                    None => said.push((code, index, place, 1)),
                }
            }
            match code {
                3 | 4 => turns = true,
                7 | 8 | 50 | 51 => flows = true,
                13 | 14 => (turns, flows) = (true, true),
                5 | 19 => turns = false,
                9 => flows = false,
                0 => (turns, flows) = (false, false),
                _ => {}
            }
        }
        // Nothing is left to the next program.
        if ends_program(words) {
            (turns, flows) = (false, false);
        }
    }
    for (code, block, place, count) in said {
        let Some((range, _)) = tape.word(block, place) else { continue };
        let message = if is_open(code) {
            format!(
                "ISO 1056 leaves open whether M{code:02} acts before, with or after the motion of its block. Put it into \
                 a block of its own, or declare in the itemized data when it acts."
            )
        } else {
            let what = if code == 9 { "the coolant runs" } else { "the spindle turns" };
            format!(
                "M{code:02} acts after the motion of its block: {what} until the cut has ended. If it is to stop before, \
                 put M{code:02} into the block before."
            )
        };
        sink.report(&RULE, range, message).count(count);
    }
}

fn is_open(code: u8) -> bool {
    matches!(miscellaneous(code), Miscellaneous::Assigned(_, Start::Open, ..))
}

fn moves(tape: &TapeView<'_>, block: usize) -> bool {
    !tape.execution.spans.of_block(block).is_empty()
}

fn cuts(tape: &TapeView<'_>, block: usize) -> bool {
    let spans = &tape.execution.spans;
    spans.list[spans.of_block(block)].iter().any(|span| !matches!(span.kind, SpanKind::Rapid | SpanKind::Dwell))
}
