//! NUM: digits and signs.

pub(crate) mod beyond_a_turn;
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
pub(crate) mod wrong_count;

use crate::diagnostic::Fix;
use crate::read::{BlockView, Word};

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
