//! FEED-03: the reciprocal of time is so small that its rounding changes the feed by much.

use crate::execute::EventKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "coarse-time-reciprocal",
    title: "The reciprocal of time is so small that its rounding changes the feed by much.",
    verdicts: Verdicts::contouring("FEED-03", Severity::Info),
    clauses: &[Clause::Iso2539("A.1.1")],
    page: page!("FEED-03"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter_map(|event| match event.kind {
        EventKind::CoarseReciprocal { word, feed, step } => Some((tape.word(event.block, word)?.0, feed, step)),
        _ => None,
    });
    let Some((range, feed, step)) = found.next() else { return };
    let unit = tape.control.unit.name();
    let message = format!(
        "{} makes {feed:.0} {unit}/min of this block, and the next number {:.0}: no feed between them can be written. A \
         shorter block has a greater number and a finer step.",
        &tape.text[range.clone()],
        feed + step
    );
    sink.report(&RULE, range, message).count(1 + found.count());
}
