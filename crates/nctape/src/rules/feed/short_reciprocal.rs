//! FEED-01: the reciprocal of time has fewer than four digits.

use crate::format::{Detail, FeedCoding};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "short-time-reciprocal",
    title: "The reciprocal of time has fewer than four digits.",
    verdicts: Verdicts::contouring("FEED-01", Severity::Error),
    clauses: &[Clause::Iso2539("A.1")],
    page: page!("FEED-01"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    if control.format.itemized.feed != Some(FeedCoding::TimeReciprocal) {
        return;
    }
    let feeds = detail.words.iter().filter(|word| word.address == 'F' && !word.digits.is_empty());
    if let Some(word) = feeds.into_iter().find(|word| word.width() < 4) {
        let message = format!(
            "{} gives the feed {}; the reciprocal of time has four or more. Write F4, or another coding of the feed.",
            word.text(),
            digits(u16::from(word.width()))
        );
        sink.report(&RULE, word.range.clone(), message);
    }
}
