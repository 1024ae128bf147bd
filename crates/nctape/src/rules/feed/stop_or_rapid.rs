//! FEED-10: the geometric code 00 or 99 stands where it is no speed.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "stop-or-rapid-code",
    title: "The geometric code 00 or 99 stands where it is no speed.",
    verdicts: Verdicts::all("FEED-10", Severity::Warning),
    clauses: &[Clause::Iso2539("A.3"), Clause::Iso1058("A.2.1")],
    page: page!("FEED-10"),
};

/// Said once for each of the two, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let events = || tape.execution.events.iter();
    let mut stops = events().filter(|event| matches!(event.kind, EventKind::StopFeed));
    if let Some(event) = stops.next() {
        let message = "The block cuts, but the feed code in force is 00, which is stop: the tool does not move. Write \
                       the code of a feed.";
        sink.report(&RULE, tape.extent(event.block), message.to_owned()).count(1 + stops.count());
    }
    let mut rapids = events().filter_map(|event| match event.kind {
        EventKind::RapidSpeed { word } => tape.word(event.block, word),
        _ => None,
    });
    if let Some((range, _)) = rapids.next() {
        let message =
            "S99 is no spindle speed: 99 is rapid traverse, which only a feed can be. Write a code from 00 to 98.";
        sink.report(&RULE, range, message.to_owned()).count(1 + rapids.count());
    }
}
