//! NUM: digits and signs.

pub(crate) mod beyond_a_turn;
pub(crate) mod both_zeros;
pub(crate) mod decimal_sign;
pub(crate) mod incremental_sign_missing;
pub(crate) mod minus_zero;
pub(crate) mod miscellaneous;
pub(crate) mod out_of_travel;
pub(crate) mod preparatory;
pub(crate) mod sign_forbidden;
pub(crate) mod sign_inside;
pub(crate) mod sign_missing;
pub(crate) mod sign_on_function;
pub(crate) mod too_few;
pub(crate) mod too_many;
pub(crate) mod tool;
pub(crate) mod turns_recommended;
pub(crate) mod wrong_count;

use crate::diagnostic::Fix;
use crate::format::Designation;
use crate::read::{BlockView, Word};

/// The letter O follows the number at once: the word goes on behind it, and WORD-14 says so.
fn is_cut_by_letter(word: &Word, block: &BlockView<'_>) -> bool {
    block.text[word.range().end..].starts_with(['O', 'o'])
}

/// Zero in a column of a T system, written with fewer zeros than the word has digits (3.3.1).
fn is_short_zero(word: &Word, designation: &Designation) -> bool {
    word.by_column && word.value == Some(0) && word.digits < u16::from(designation.width())
}

/// Puts a plus sign before the first digit of a word.
fn write_plus(word: &Word, block: &BlockView<'_>) -> Fix {
    let range = word.range();
    let first = block.text[range.clone()].find(|c: char| c.is_ascii_digit()).map_or(range.end, |at| range.start + at);
    Fix::replace("Write +", first..first, "+")
}

/// Takes the sign of a word out.
fn leave_sign_out(word: &Word, block: &BlockView<'_>) -> Fix {
    let range = word.range();
    let sign = block.text[range.clone()].find(['+', '-']).map_or(range.start..range.start, |at| {
        let at = range.start + at;
        at..at + 1
    });
    Fix::replace("Leave the sign out", sign, "")
}

#[cfg(test)]
mod tests {
    use crate::{Format, Severity, Standard, Tape};

    #[test]
    fn a_letter_o_in_a_number_is_the_only_fault() {
        let format = Format::new(Standard::Iso2539, "N3G2X+42Y+32F4S3T2M2*").classified("CAM 222");
        for text in ["%\nN001 G00 X+001O00 M30\n", "%\nN001 G00 X+001000 T1O M30\n", "%\nN001 G0O X+001000 M30\n"] {
            let tape = Tape::new(text, &format);
            let errors = tape.diagnostics().into_iter().filter(|found| found.severity == Severity::Error);
            let found: Vec<&str> = errors.map(|found| found.id).collect();
            assert_eq!(found, ["WORD-14"], "{text}");
        }
    }
}
