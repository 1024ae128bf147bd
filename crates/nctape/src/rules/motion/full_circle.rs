//! MOT-11: an arc ends where it starts.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "full-circle-not-stated",
    title: "An arc ends where it starts.",
    verdicts: Verdicts::contouring("MOT-11", Severity::Info),
    clauses: &[Clause::Iso2539("4.2 note")],
    page: page!("MOT-11"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter(|event| matches!(event.kind, EventKind::FullCircle));
    let Some(event) = found.next() else { return };
    let state = |full: bool| {
        let mut format = tape.control.format.clone();
        format.itemized.full_circle = Some(full);
        let title = if full { "State fullCircle: a full circle" } else { "State fullCircle: no motion" };
        Fix::reformat(title, format)
    };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The arc ends where it starts; it is read as a full circle. The standard leaves that to the control: state fullCircle \
         in the itemized data."
            .to_owned(),
    )
    .count(1 + found.count())
    .fix(|| state(true))
    .fix(|| state(false));
}
