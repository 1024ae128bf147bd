//! FEED-14: the feed is above the greatest one of the machine.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "feed-above-maximum",
    title: "The feed is above the greatest one of the machine.",
    verdicts: Verdicts::all("FEED-14", Severity::Warning),
    clauses: &[Clause::Both("annex A")],
    page: page!("FEED-14"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::TooFast { word, feed } = event.kind else { return };
    let Some(most) = tape.control.format.itemized.maximum_feed else { return };
    let unit = tape.control.unit.name();
    let (range, what) = match word.and_then(|word| tape.word(event.block, word)) {
        Some((range, _)) => (range, "F says"),
        None => (tape.extent(event.block), "This block moves at"),
    };
    let message = format!(
        "{what} {} {unit}/min; the greatest feed of the machine is {} {unit}/min (maximumFeed). Write a smaller one.",
        rounded(feed),
        rounded(most.0)
    );
    sink.report(&RULE, range, message);
}

/// With three decimal places at most.
fn rounded(feed: f64) -> f64 {
    if feed < 1e12 { (feed * 1e3).round() / 1e3 } else { feed }
}
