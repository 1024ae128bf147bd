//! FEED-17: the spindle is started before any speed was given.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "spindle-without-speed",
    title: "The spindle is started before any speed was given.",
    verdicts: Verdicts::all("FEED-17", Severity::Info),
    clauses: &[],
    page: page!("FEED-17"),
};

/// Said once, with how many words it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter_map(|event| match event.kind {
        EventKind::SpindleWithoutSpeed { word } => tape.word(event.block, word),
        _ => None,
    });
    let Some((range, _)) = found.next() else { return };
    let message = format!(
        "{} starts the spindle before any S was given: it turns at the speed that it last had. Give S here or before.",
        &tape.text[range.clone()]
    );
    sink.report(&RULE, range, message).count(1 + found.count());
}
