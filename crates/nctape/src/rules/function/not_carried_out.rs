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
}
