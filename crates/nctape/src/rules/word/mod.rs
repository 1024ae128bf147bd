//! WORD: addresses and their order.

pub(crate) mod dimension_order;
pub(crate) mod letter_o;
pub(crate) mod no_address;
pub(crate) mod no_digits;
pub(crate) mod order;
pub(crate) mod parameters;
pub(crate) mod repeated;
pub(crate) mod two_miscellaneous;
pub(crate) mod two_tools;
pub(crate) mod unassigned_letter;
pub(crate) mod unknown_address;

use crate::format::Control;
use crate::read::Word;

/// Letters that rules of their own speak of: the general rule on unknown addresses keeps quiet about them.
fn has_rule_of_its_own(word: &Word, control: &Control) -> bool {
    match word.address {
        b'H' | b'L' | b'O' => true,
        b'I' | b'J' | b'K' => control.standard() == crate::format::Standard::Iso1058,
        _ => false,
    }
}

/// The address stands in the detail, or the itemized data gives it a meaning.
fn is_known(word: &Word, control: &Control) -> bool {
    control.designation(word.address).is_some()
        || word.address == b':' && control.designation(b'N').is_some()
        || crate::rules::is_declared_letter(word.letter(), control)
}
