//! WORD-19: a feed word stands before a dimension word that it applies to.

use super::FeedWords;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "feed-before-dimensions",
    title: "A feed word stands before a dimension word that it applies to.",
    verdicts: Verdicts::contouring("WORD-19", Severity::Error),
    clauses: &[Clause::Iso2539("3.2.2.3")],
    page: page!("WORD-19"),
};

pub(crate) fn check(block: &FeedWords<'_>, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let mut feeds = block.feeds(tape.control);
    let (Some(place), None) = (feeds.next(), feeds.next()) else { return };
    // While positioning, a feed word right behind a dimension word is that of its axis.
    if !block.contouring && place > 0 && block.is_dimension(place - 1, tape.control) {
        return;
    }
    let last = (place..block.words.len()).rev().find(|&place| block.is_dimension(place, tape.control));
    let Some(last) = last.map(|place| &block.words[place]) else { return };
    let feed = &block.words[place];
    let message = format!(
        "{} stands before {}; a feed for the whole block follows the last dimension word. Move it behind.",
        feed.letter(),
        last.letter()
    );
    let (from, to) = (tape.range(block.block, feed), tape.range(block.block, last).end);
    sink.report(&RULE, from.clone(), message).fixes(block.words.iter().all(|word| word.tabs == 0).then(|| {
        let blanks = from.start - tape.text[..from.start].trim_end_matches(' ').len();
        let moved = tape.text[from.start - blanks..from.end].to_owned();
        let title = format!("Move it behind {}", last.letter());
        Fix::edits(title, [(from.start - blanks..from.end, String::new()), (to..to, moved)])
    }));
}
