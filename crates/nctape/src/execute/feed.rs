//! What an F word says (annex A).

use crate::format::{Control, FeedCoding, FeedUnit, SpindleCoding, power_of_ten};
use crate::read::Word;

/// What the feed in force says of a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Feed {
    /// No F yet.
    None,
    /// Unit per minute along the path.
    PerMinute(f64),
    /// Unit per revolution of the spindle.
    PerRevolution(f64),
    /// The reciprocal of time (A.1): the F word's number over the scale.
    Reciprocal(f64),
    /// An F word that says no number.
    Unknown,
}

/// The R20 series from 1 to 10 in hundredths: the ratios of the geometric table (ISO 1058 A.2.1), code by code. The
/// printed table holds rounded values, up to 1,22 % off the exact power, so it is a table and not a power.
const R20_HUNDREDTHS: [i64; 20] =
    [100, 112, 125, 140, 160, 180, 200, 224, 250, 280, 315, 355, 400, 450, 500, 560, 630, 710, 800, 900];

/// The speed of a two-digit code of the geometric table (ISO 1058 A.2.1): 0 is stop, 99 is rapid and no number.
pub(crate) fn geometric(code: i64, shift: u8) -> Option<f64> {
    match code {
        0 => Some(0.0),
        1..=98 => Some(scaled(R20_HUNDREDTHS[(code % 20) as usize], code / 20 - 2 - i64::from(shift.min(9)))),
        _ => None,
    }
}

/// The speed of an arithmetic code of `digits` digits (ISO 2539 A.2.2): the first digit is three more than the
/// digits before the decimal sign, the others are the speed's leading digits.
pub(crate) fn arithmetic(code: i64, digits: u16) -> Option<f64> {
    if !(3..=5).contains(&digits) || code < 0 {
        return None;
    }
    let scale = power_of_ten(digits as u8 - 1);
    let (first, mantissa) = (code / scale, code % scale);
    if mantissa == 0 && first == 0 {
        return Some(0.0);
    }
    // The second digit is never zero unless all are (note to A.2.2).
    if mantissa < scale / 10 || first > 9 {
        return None;
    }
    Some(scaled(mantissa, first - 3 - i64::from(digits - 1)))
}

/// A whole number times a power of ten from -11 to 9, by one exact division or multiplication.
fn scaled(number: i64, exponent: i64) -> f64 {
    let power = power_of_ten(exponent.unsigned_abs() as u8) as f64;
    if exponent < 0 { number as f64 / power } else { number as f64 * power }
}

/// What an F word says under a coding; G93 to G95 may have changed the one of the format.
pub(crate) fn read_feed(word: &Word, control: &Control, coding: FeedCoding, unit: FeedUnit) -> Feed {
    let Some(code) = word.value else { return Feed::Unknown };
    let stated = &control.format.itemized;
    let places = control.designation(b'F').map_or(0, |word| word.after);
    let direct = || code as f64 / power_of_ten(places) as f64;
    let speed = match coding {
        FeedCoding::TimeReciprocal => return Feed::Reciprocal(direct() / control.time_scale),
        FeedCoding::Direct => Some(direct()),
        FeedCoding::Arithmetic => arithmetic(code, word.digits),
        FeedCoding::Geometric => geometric(code, stated.decimal_shift.unwrap_or(0)),
        FeedCoding::Symbolic => stated.symbolic_feeds.as_ref().and_then(|table| symbolic(table, code)),
    };
    match (speed, unit) {
        (Some(speed), FeedUnit::PerMinute) => Feed::PerMinute(speed),
        (Some(speed), FeedUnit::PerRevolution) => Feed::PerRevolution(speed),
        (None, _) => Feed::Unknown,
    }
}

/// Revolutions per minute of an S word under the control's coding.
pub(crate) fn read_speed(word: &Word, control: &Control) -> Option<f64> {
    let code = word.value?;
    let stated = &control.format.itemized;
    let places = control.designation(b'S').map_or(0, |word| word.after);
    match control.spindle {
        SpindleCoding::Direct => Some(code as f64 / power_of_ten(places) as f64),
        SpindleCoding::Arithmetic => arithmetic(code, word.digits),
        SpindleCoding::Geometric => geometric(code, stated.decimal_shift.unwrap_or(0)),
        SpindleCoding::Symbolic => stated.symbolic_speeds.as_ref().and_then(|table| symbolic(table, code)),
    }
}

/// What is wrong with the code of an F or S word, its count of digits apart.
pub(crate) enum CodeFault {
    /// A symbolic code without a value.
    Unlisted,
    /// An arithmetic code whose second digit is zero though not all are.
    SecondDigitZero,
    /// The geometric code 99, rapid.
    Rapid,
}

/// What is wrong with an F word under a coding.
pub(crate) fn feed_fault(word: &Word, control: &Control, coding: FeedCoding) -> Option<CodeFault> {
    let code = word.value?;
    match coding {
        FeedCoding::Symbolic => unlisted(control.format.itemized.symbolic_feeds.as_ref(), code),
        FeedCoding::Arithmetic => second_digit_zero(code, word, control),
        FeedCoding::Geometric | FeedCoding::Direct | FeedCoding::TimeReciprocal => None,
    }
}

/// What is wrong with an S word under the control's coding.
pub(crate) fn speed_fault(word: &Word, control: &Control) -> Option<CodeFault> {
    let code = word.value?;
    match control.spindle {
        SpindleCoding::Symbolic => unlisted(control.format.itemized.symbolic_speeds.as_ref(), code),
        SpindleCoding::Arithmetic => second_digit_zero(code, word, control),
        SpindleCoding::Geometric => (code == 99 && word.digits == 2).then_some(CodeFault::Rapid),
        SpindleCoding::Direct => None,
    }
}

fn unlisted(table: Option<&std::collections::BTreeMap<String, f64>>, code: i64) -> Option<CodeFault> {
    table.and_then(|table| symbolic(table, code)).is_none().then_some(CodeFault::Unlisted)
}

/// Of a code that has its digits; where it has not, that is what is wrong with it (FEED-07).
fn second_digit_zero(code: i64, word: &Word, control: &Control) -> Option<CodeFault> {
    let whole = control.designation(word.address).is_some_and(|it| u16::from(it.width()) == word.digits);
    let zero = whole && (3..=5).contains(&word.digits) && arithmetic(code, word.digits).is_none();
    zero.then_some(CodeFault::SecondDigitZero)
}

/// The value of a symbolic code: the table may write "7" or "07".
fn symbolic(table: &std::collections::BTreeMap<String, f64>, code: i64) -> Option<f64> {
    table.iter().find(|(name, _)| name.trim().parse() == Ok(code)).map(|(_, value)| *value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every entry of the tables printed in ISO 2539 A.2.2 and ISO 1058 A.1.1: code, digits, the speed that its
    /// digits say.
    #[test]
    fn arithmetic_codes_of_the_printed_tables() {
        let rows: [(i64, i64, i64, [f64; 3]); 8] = [
            (717, 7173, 71728, [1700.0, 1730.0, 1728.0]),
            (615, 6150, 61503, [150.0, 150.0, 150.3]),
            (515, 5153, 51525, [15.0, 15.3, 15.25]),
            (478, 4783, 47826, [7.8, 7.83, 7.826]),
            (315, 3154, 31537, [0.15, 0.154, 0.1537]),
            (213, 2127, 21268, [0.013, 0.0127, 0.01268]),
            (188, 1876, 18759, [0.0088, 0.00876, 0.008759]),
            (46, 462, 4624, [0.00046, 0.000462, 0.0004624]),
        ];
        for (three, four, five, speeds) in rows {
            for (code, digits, speed) in [(three, 3, speeds[0]), (four, 4, speeds[1]), (five, 5, speeds[2])] {
                assert_eq!(arithmetic(code, digits), Some(speed), "{code}");
            }
        }
        assert_eq!(arithmetic(0, 3), Some(0.0));
        assert_eq!(arithmetic(605, 3), None, "a second digit of zero");
    }

    /// Entries of the table printed in ISO 1058 A.2.1, spread over all decades.
    #[test]
    fn geometric_codes_of_the_printed_table() {
        let printed = [
            (0, 0.0),
            (1, 1.12),
            (5, 1.8),
            (19, 9.0),
            (20, 10.0),
            (30, 31.5),
            (34, 50.0),
            (41, 112.0),
            (50, 315.0),
            (67, 2240.0),
            (68, 2500.0),
            (80, 10000.0),
            (98, 80000.0),
        ];
        for (code, speed) in printed {
            assert_eq!(geometric(code, 0), Some(speed), "{code}");
        }
        assert_eq!(geometric(50, 1), Some(31.5), "moved one place to the left (A.2.3)");
        assert_eq!(geometric(99, 0), None, "rapid is no number");
    }
}
