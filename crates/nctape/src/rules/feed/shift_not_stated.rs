//! FEED-11: the geometric table seems to be moved, and the format does not say so.

use crate::format::{FeedCoding, FeedUnit};
use crate::read::Block;
use crate::rules::prelude::*;
use crate::speed::{Speed, geometric};

/// The rule.
pub static RULE: Rule = Rule {
    name: "decimal-shift-not-stated",
    title: "The geometric table seems to be moved, and the format does not say so.",
    verdicts: Verdicts::positioning("FEED-11", Severity::Error),
    clauses: &[Clause::Iso1058("A.2.3")],
    page: page!("FEED-11"),
};

/// Places that a table may sensibly be moved: from metres a minute to thousandths of a millimetre.
const SHIFTS: std::ops::RangeInclusive<u8> = 1..=4;

/// The word says how long its block dwells, and no feed.
fn is_dwell(tape: &TapeView<'_>, block: &Block, word: &Word) -> bool {
    let dwells = tape.control.format.itemized.dwell.as_ref().is_some_and(|dwell| dwell.address == word.letter());
    dwells && tape.reading.words(block).iter().any(|word| word.function(b'G') == Some(4))
}

/// Said once, with how many words it holds for. Tells whether it was said, which it is in place of FEED-14.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) -> bool {
    let (control, stated) = (tape.control, &tape.control.format.itemized);
    let geometric_feeds = control.feed == FeedCoding::Geometric && control.feed_unit == FeedUnit::PerMinute;
    let Some(most) = stated.maximum_feed.filter(|_| geometric_feeds && stated.decimal_shift.is_none()) else {
        return false;
    };
    if RULE.verdicts.under(control.standard()).is_none() {
        return false;
    }
    let mut words = Vec::new();
    for (block, word) in tape.words() {
        if is_dwell(tape, block, word) {
            continue;
        }
        match word.function(b'G') {
            Some(93 | 95) => return false,
            _ if word.address != b'F' => continue,
            _ => {}
        }
        let Some(code) = word.value.filter(|_| word.digits == 2) else { return false };
        match geometric::decode(code, 0) {
            Ok(Speed::Is(feed)) if feed > most.0 => words.push((tape.range(block, word), code, feed)),
            // Stop and rapid traverse are so under every shift.
            Ok(Speed::Rapid) | Ok(Speed::Is(0.0)) => {}
            _ => return false,
        }
    }
    let Some((range, code, feed)) = words.first().cloned() else { return false };
    let fastest = words.iter().map(|word| word.1).max().unwrap_or(code);
    let fits = |shift: &u8| matches!(geometric::decode(fastest, *shift), Ok(Speed::Is(feed)) if feed <= most.0);
    // Different codes, all of them too fast, are no slip: one alone is a feed that was mistaken (FEED-14).
    let Some(shift) = SHIFTS.into_iter().find(fits).filter(|_| words.iter().any(|word| word.1 != code)) else {
        return false;
    };
    let Ok(Speed::Is(moved)) = geometric::decode(code, shift) else { return false };
    let unit = control.unit.name();
    let places = if shift == 1 { "one place".to_owned() } else { format!("{shift} places") };
    let message = format!(
        "{} says {feed} {unit}/min, and every other F here is above the greatest feed of the machine, {} {unit}/min \
         (maximumFeed), too. With the decimal sign of the table {places} further left they fit, and this one says {moved}: \
         state decimalShift.",
        &tape.text[range.clone()],
        most.0
    );
    let mut format = control.format.clone();
    format.itemized.decimal_shift = Some(shift);
    sink.report(&RULE, range, message)
        .count(words.len())
        .fix(|| Fix::reformat(format!("State decimalShift: {shift}"), format));
    true
}
