//! WORD-18: the feed word of an axis does not follow the word of that axis.

use super::FeedWords;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "feed-apart-from-its-axis",
    title: "The feed word of an axis does not follow the word of that axis.",
    verdicts: Verdicts::contouring("WORD-18", Severity::Error),
    clauses: &[Clause::Iso2539("3.2.2.3")],
    page: page!("WORD-18"),
};

pub(crate) fn check(block: &FeedWords<'_>, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if block.contouring || block.feeds(tape.control).nth(1).is_none() {
        return;
    }
    let follows_axis = |&place: &usize| place > 0 && block.is_dimension(place - 1, tape.control);
    let Some(place) = block.feeds(tape.control).find(|place| !follows_axis(place)) else { return };
    let letter = block.words[place].letter();
    let message = format!(
        "{letter} follows no dimension word. A block with several feed words has one for an axis right behind the word \
         of that axis. Move {letter} there."
    );
    sink.report(&RULE, tape.range(block.block, &block.words[place]), message);
}
