//! Words of which no rule on a single word has anything to say: most words of most tapes, told at a glance.

use super::feed;
use super::word::no_address;
use crate::format::{Sign, Standard};
use crate::function::{Preparatory, preparatory};
use crate::read::{BlockView, NumberFault, Word};

/// The word has the digits and the sign of its designation, and is of a kind whose rules all ask for just that.
///
/// It may be false of a word that has no fault; then the rules are asked. That it is never true of one that has is what
/// [`super::check_block`] asserts wherever debug assertions are on: in every test.
pub(super) fn is_sound(word: &Word, block: &BlockView<'_>) -> bool {
    let control = block.control;
    let Some(designation) = control.designation(word.address) else { return false };
    let whole = word.digits == u16::from(designation.width()) && word.value.is_some() && !word.by_column;
    if word.fault != NumberFault::None || !whole {
        return false;
    }
    let is_1058 = control.standard() == Standard::Iso1058;
    match word.address {
        b'X' | b'Y' | b'Z' | b'I' | b'J' | b'K' => {
            let signed = word.sign.is_some() == (designation.sign != Sign::Positive);
            let minus_zero = word.sign == Some(b'-') && word.value == Some(0);
            designation.dimension && signed && !minus_zero && !(is_1058 && word.address < b'X')
        }
        b'N' => {
            let digits = word.digits == 3 || word.digits > 3 && !is_1058;
            digits && word.sign.is_none() && no_address::run_in(word, block).is_none()
        }
        b'F' => word.sign.is_none() && !designation.dimension && feed::coding(b'F', control).is_none(),
        b'G' => {
            word.digits == 2 && word.sign.is_none() && word.function(b'G').is_some_and(|code| is_plain(code, is_1058))
        }
        _ => false,
    }
}

/// A preparatory function that a control may have under any format.
fn is_plain(code: u8, is_1058: bool) -> bool {
    let barred = matches!(code, 90 | 91) || is_1058 && matches!(code, 2 | 3 | 6 | 93);
    !barred && matches!(preparatory(code), Preparatory::Assigned(..))
}
