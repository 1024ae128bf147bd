//! MOT-19: incremental dimensions do not sum to zero.

use crate::execute::EventKind;
use crate::format::{Dimensions, Sign};
use crate::read::Traits;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "open-path",
    title: "Incremental dimensions do not sum to zero.",
    verdicts: Verdicts::all("MOT-19", Severity::Info),
    clauses: &[],
    page: page!("MOT-19"),
};

/// Only where every dimension word of an axis adds up: under absolute dimensions any end is as good as another, and a
/// tape that changes over or sets its registers has said where it is.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let [(last, true)] = tape.execution.ends[..] else { return };
    let spans = &tape.execution.spans;
    let Some(end) = spans.list.len().checked_sub(1) else { return };
    let (start, end) = (spans.start(0), spans.end(end));
    let throughout = tape.control.dimensions == Dimensions::Incremental;
    let adds_up = |axis: usize| match tape.control.axes[axis].sign {
        None => false,
        Some(_) if tape.control.standard() == Standard::Rs274 => throughout,
        Some(Sign::Incremental) => true,
        Some(Sign::Both) => throughout,
        Some(_) => false,
    };
    let open: Vec<usize> = (0..start.len()).filter(|&axis| adds_up(axis) && start[axis] != end[axis]).collect();
    // One move alone is no path that could close, and a word that could not be read may be what is missing.
    if open.is_empty() || spans.list.len() < 2 || changes_over(tape) || !is_known(tape) {
        return;
    }
    let apart: Vec<String> = open
        .iter()
        .map(|&axis| {
            let written = &tape.control.axes[axis];
            format!("{} {:+.*}", written.letter, usize::from(written.decimals), end[axis] - start[axis])
        })
        .collect();
    let message = format!(
        "The increments do not sum to zero: the path ends {} away from where it begins, and a second run of the tape begins \
         there. If it is to close, correct the word that is wrong or add a block that leads back.",
        apart.join(", ")
    );
    sink.report(&RULE, tape.extent(last), message);
}

/// A block gives G90, absolute dimensions, or G92, which sets the registers.
fn changes_over(tape: &TapeView<'_>) -> bool {
    let blocks = tape.reading.blocks.iter().filter(|block| block.traits.any(Traits::address(b'G')));
    blocks.flat_map(|block| tape.reading.words(block)).any(|word| matches!(word.function(b'G'), Some(90 | 92)))
}

/// Every motion of the tape could be read and computed.
fn is_known(tape: &TapeView<'_>) -> bool {
    let left_out = tape.execution.events.iter().any(|event| event.kind == EventKind::LeftOut);
    !left_out && !tape.execution.spans.list.iter().any(|span| span.substitute)
}
