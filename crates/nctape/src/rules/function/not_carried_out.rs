//! FUN-09: a function is read, but the path does not show what it does.

use crate::execute::EventKind;
use crate::function::{Preparatory, preparatory};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "function-not-drawn",
    title: "A function is read, but the path does not show what it does.",
    verdicts: Verdicts::all("FUN-09", Severity::Info),
    clauses: &[],
    page: page!("FUN-09"),
};

/// Said once for each function, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut said: Vec<(u8, usize, usize)> = Vec::new();
    for event in &tape.execution.events {
        if let EventKind::NotCarriedOut(code) = event.kind {
            match said.iter_mut().find(|(other, ..)| *other == code) {
                Some((.., count)) => *count += 1,
                None => said.push((code, event.block, 1)),
            }
        }
    }
    for (code, block, count) in said {
        let name = format!("G{code:02}");
        let declared = tape.control.format.itemized.declared.as_ref();
        let meaning = match preparatory(code) {
            Preparatory::Assigned(_, meaning) => meaning,
            _ => declared.and_then(|declared| declared.g.get(&name)).map_or("declared", String::as_str),
        };
        let message = if code == 4 && tape.control.format.itemized.dwell.is_none() {
            "G04 (Dwell) is read and checked, but the format does not state which word says how long: times here leave it \
             out. State dwell in the itemized data."
                .to_owned()
        } else if code == 4 {
            "G04 (Dwell) has no word that says how long, or a negative one: times here leave it out.".to_owned()
        } else if code == 92 {
            "G92 (Preload of registers) moves no tool: from here the dimensions count from another origin. The path is \
             drawn in the new coordinates, so that it seems to jump."
                .to_owned()
        } else if matches!(code, 34 | 35) {
            format!(
                "{name} ({meaning}) is in force from here. The path is drawn, and I, J and K are taken as the first lead; by \
                 how much it changes with every revolution no word of the standards says, so that no time is known."
            )
        } else if matches!(code, 41 | 42) {
            format!(
                "{name} ({meaning}) is in force from here. The path drawn is the programmed one; state the radius of the \
                 cutter in the format (cutterRadius) to see that of its centre beside it."
            )
        } else {
            format!(
                "{name} ({meaning}) is read and checked, but the playground does not work out what it does to the path: \
                 positions and times here leave it out."
            )
        };
        sink.report(&RULE, tape.function(block, b'G', code), message).count(count);
    }
    check_rapid_z(tape, sink);
}

/// R may be declared as the rapid motion along Z that B.1 offers. Its order beside Z and the other words of the block, and
/// how far it takes Z, are the builder's, and no field of the format says them.
fn check_rapid_z(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let declared = tape.control.format.itemized.declared.as_ref().and_then(|declared| declared.letters.get("R"));
    let is_rapid = declared.is_some_and(|meaning| meaning.to_lowercase().contains("rapid"));
    if !is_rapid || tape.control.axis(b'R').is_none() || !tape.seen.any(Traits::address(b'R')) {
        return;
    }
    let words = tape.reading.blocks.iter().flat_map(|block| {
        tape.reading.words(block).iter().filter(|word| word.address == b'R').map(|word| tape.reading.range(block, word))
    });
    let ranges: Vec<_> = words.collect();
    if let Some(first) = ranges.first() {
        let message = "R is declared as rapid motion along Z. It is shown as an axis of its own and leaves Z where it is: in \
                       which order R and Z act in a block, and where Z is then, the standards leave to the builder.";
        sink.report(&RULE, first.clone(), message.to_owned()).count(ranges.len());
    }
}
