//! FUN-09: a function is read, but the path does not show what it does.

use crate::execute::{EventKind, Limit, ParameterReading};
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
    let mut said: Vec<(Limit, usize, usize)> = Vec::new();
    for event in &tape.execution.events {
        if let EventKind::NotCarriedOut(limit) = event.kind {
            match said.iter_mut().find(|(other, ..)| *other == limit) {
                Some((.., count)) => *count += 1,
                None => said.push((limit, event.block, 1)),
            }
        }
    }
    for (limit, block, count) in said {
        let message = match limit {
            Limit::Function(code) => {
                let name = format!("G{code:02}");
                let declared = tape.control.format.itemized.declared.as_ref();
                let meaning = match preparatory(code) {
                    Preparatory::Assigned(_, meaning) => meaning,
                    _ => declared.and_then(|declared| declared.g.get(&name)).map_or("curve", String::as_str),
                };
                if code == 92 {
                    "G92 (Preload of registers) moves no tool: from here the dimensions count from another origin. The \
                     path is drawn in the new coordinates, so that it seems to jump."
                        .to_owned()
                } else {
                    format!(
                        "G{code:02} ({meaning}) is read and checked, but the playground does not work out what it does to \
                     the path: positions and times here leave it out."
                    )
                }
            }
            Limit::Parameters(reading) => {
                let what = match reading {
                    ParameterReading::AngleRadius => "arcParameters: angle-radius",
                    ParameterReading::Slope => "parabolaParameters: slope",
                    ParameterReading::Focus => "parabolaParameters: focus",
                };
                format!(
                    "The playground does not work out the reading {what} of I, J and K: the span is drawn as a straight \
                     stand-in, its time is not known."
                )
            }
        };
        let range = match limit {
            Limit::Function(code) => tape.function(block, b'G', code),
            Limit::Parameters(_) => tape.parameters(block),
        };
        sink.report(&RULE, range, message).count(count);
    }
}
