//! SKIP-03: skipping a block changes what later blocks do.

use crate::execute::{Held, ends_program};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "skip-changes-what-follows",
    title: "Skipping a block changes what later blocks do.",
    verdicts: Verdicts::all("SKIP-03", Severity::Warning),
    clauses: &[Clause::Iso2539("B.2 note 2"), Clause::Iso1058("B.2 note 4")],
    page: page!("SKIP-03"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.other.is_some() {
        check_ends(tape, sink);
    }
    for (block, what) in changes(tape) {
        let message = format!(
            "Whether this block is skipped changes {what} for the blocks behind it. Give there again what they rest on, or \
             skip what undoes it too."
        );
        sink.report(&RULE, tape.extent(block), message);
    }
}

/// The blocks whose skipping changes what follows, and what it changes. The tape is executed with the switch both ways.
/// Behind the first block that cannot be skipped, after one that can, the control should hold the same; where it does
/// not, the blocks before it that can be skipped are at fault.
pub(crate) fn changes(tape: &TapeView<'_>) -> Vec<(usize, String)> {
    let mut changes = Vec::new();
    let Some(other) = tape.other else { return changes };
    let held = |index: usize| other.held.binary_search_by_key(&index, |held| held.0).map(|at| &other.held[at].1);
    // What only one of them executes is no matter here.
    let pairs = tape.execution.held.iter().filter_map(|(index, one)| Some((*index, one, held(*index).ok()?)));
    let mut differed = false;
    let mut before = 0;
    for (index, one, another) in pairs {
        let differs = one != another;
        let skipped = (before..index).find(|&block| tape.reading.blocks[block].skip);
        if let (true, false, Some(block)) = (differs, differed, skipped) {
            changes.push((block, what(tape, one, another)));
        }
        differed = differs;
        before = index + 1;
    }
    changes
}

/// An end of program that can be skipped: the blocks behind it are executed, or are not.
fn check_ends(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let blocks = &tape.reading.blocks;
    for (index, pair) in blocks.windows(2).enumerate() {
        let ends = pair[0].skip && pair[0].traits.any(Traits::address(b'M'));
        if ends && pair[0].program == pair[1].program && ends_program(tape.reading.words(&pair[0])) {
            let message = "Whether this block is skipped decides whether the blocks behind it are executed at all: it \
                           ends the program. If that is meant, say so beside the tape."
                .to_owned();
            sink.report(&RULE, tape.extent(index), message);
        }
    }
}

/// What the control holds differently: axes, functions or speeds.
fn what(tape: &TapeView<'_>, one: &Held, another: &Held) -> String {
    let axes = one.position.iter().zip(another.position.iter()).zip(&tape.control.axes);
    let moved: Vec<String> =
        axes.filter(|((one, another), _)| one != another).map(|(_, axis)| axis.letter.to_string()).collect();
    match (moved.is_empty(), one.mode == another.mode) {
        (false, true) => moved.join(", "),
        (false, false) => format!("{} and a modal function or speed", moved.join(", ")),
        _ => "a modal function or speed".to_owned(),
    }
}
