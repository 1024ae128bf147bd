//! What the F and S words in force say (annex A); how their codes are read is in [`crate::speed`].

use crate::format::{Control, FeedCoding, FeedUnit};
use crate::read::Word;
use crate::speed::{BadCode, Code, Coding, Speed};

/// What the feed in force says of a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Feed {
    /// No F yet.
    None,
    /// Unit per minute along the path.
    PerMinute(f64),
    /// Unit per revolution of the spindle.
    PerRevolution(f64),
    /// The reciprocal of time (A.1): how many times a minute holds the block.
    Reciprocal(f64),
    /// As fast as the machine moves: the highest code.
    Rapid,
    /// An F word that says no number.
    Unknown,
}

/// What is wrong with the code of an F or S word, its count of digits apart.
pub(crate) enum CodeFault {
    /// A symbolic code without a value.
    Unlisted,
    /// An arithmetic code whose second digit is zero though not all are.
    SecondDigitZero,
    /// Rapid traverse as a spindle speed: the geometric code 99.
    Rapid,
}

/// What an F word says under a coding, which G93 to G95 may have made another than the format's.
pub(crate) fn read_feed(
    word: &Word,
    control: &Control,
    method: FeedCoding,
    unit: FeedUnit,
) -> (Feed, Option<CodeFault>) {
    let coding = Coding::of(control, b'F').under(method);
    let (speed, fault) = read(word, &coding);
    let feed = match (speed, method, unit) {
        (Some(Speed::Is(rate)), FeedCoding::TimeReciprocal, _) => Feed::Reciprocal(rate),
        (Some(Speed::Is(feed)), _, FeedUnit::PerMinute) => Feed::PerMinute(feed),
        (Some(Speed::Is(feed)), _, FeedUnit::PerRevolution) => Feed::PerRevolution(feed),
        (Some(Speed::Rapid), ..) => Feed::Rapid,
        (None, ..) => Feed::Unknown,
    };
    (feed, fault)
}

/// Revolutions per minute of an S word.
pub(crate) fn read_speed(word: &Word, control: &Control) -> (Option<f64>, Option<CodeFault>) {
    let (speed, fault) = read(word, &Coding::of(control, b'S'));
    let rapid = speed == Some(Speed::Rapid) && word.digits == 2;
    (speed.and_then(Speed::number), fault.or(rapid.then_some(CodeFault::Rapid)))
}

fn read(word: &Word, coding: &Coding<'_>) -> (Option<Speed>, Option<CodeFault>) {
    let Some(number) = word.value else { return (None, None) };
    match coding.decode(Code { number, digits: word.digits }) {
        Ok(speed) => (Some(speed), None),
        Err(BadCode::Unlisted) => (None, Some(CodeFault::Unlisted)),
        // Of a code that has its digits; where it has not, that is what is wrong with it (FEED-07).
        Err(BadCode::SecondDigitZero) if coding.digits == word.digits => (None, Some(CodeFault::SecondDigitZero)),
        Err(_) => (None, None),
    }
}
