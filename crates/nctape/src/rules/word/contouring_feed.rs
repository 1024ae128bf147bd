//! WORD-20: axes have feeds of their own while contouring.

use super::FeedWords;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "separate-feeds-in-contouring",
    title: "Axes have feeds of their own while contouring.",
    verdicts: Verdicts::contouring("WORD-20", Severity::Error),
    clauses: &[Clause::Iso2539("3.2.2.3")],
    page: page!("WORD-20"),
};

pub(crate) fn check(block: &FeedWords<'_>, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut feeds = block.feeds(tape.control).filter(|_| block.contouring);
    let Some((first, second)) = feeds.next().zip(feeds.next()) else { return };
    let (first, second) = (&block.words[first], &block.words[second]);
    let message = format!(
        "{} is a second feed in a block that contours: one feed holds along the path, for all axes. Keep one, behind the \
         last dimension word.",
        second.letter()
    );
    sink.report(&RULE, tape.range(block.block, second), message)
        .related(tape.range(block.block, first), "the first feed word");
}
