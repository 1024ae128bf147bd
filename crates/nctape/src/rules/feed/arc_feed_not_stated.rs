//! FEED-04: the feed on arcs has two readings.

use crate::execute::EventKind;
use crate::format::ArcFeed;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "arc-feed-not-stated",
    title: "The feed on arcs has two readings.",
    verdicts: Verdicts::contouring("FEED-04", Severity::Warning),
    clauses: &[Clause::Iso2539("A.1.2"), Clause::Iso2539("annex E")],
    page: page!("FEED-04"),
};

/// Said once, with how many arcs it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut found = tape.execution.events.iter().filter_map(|event| match event.kind {
        EventKind::ArcFeedNotStated { by_radians, by_time } => Some((event.block, by_radians, by_time)),
        _ => None,
    });
    let Some((block, by_radians, by_time)) = found.next() else { return };
    let count = 1 + found.count();
    let unit = tape.control.unit.name();
    let message = format!(
        "F on an arc has two readings: radians per minute (A.1.2) gives {by_radians:.0} {unit}/min here, the reciprocal \
         of time (annex E) {by_time:.0} {unit}/min. State arcFeed in the itemized data; radians are taken."
    );
    let with = |feed: ArcFeed| {
        let mut format = tape.control.format.clone();
        format.itemized.arc_feed = Some(feed);
        Fix::reformat(format!("State arcFeed: {}", feed.word()), format)
    };
    sink.report(&RULE, tape.extent(block), message)
        .count(count)
        .fix(|| with(ArcFeed::Radians))
        .fix(|| with(ArcFeed::Time));
}
