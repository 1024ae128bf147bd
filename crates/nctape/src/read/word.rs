//! One word: an address and its number.

use super::number::NumberFault;
use std::ops::Range;

/// One word of a block (3.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The address: an upper-case letter or `:`; 0 for a number without one.
    pub address: u8,
    /// The address is written in lower case.
    pub lower_case: bool,
    /// The address comes from the tab column (T system): it is not on the tape.
    pub by_column: bool,
    /// Tabs right before the word.
    pub tabs: u16,
    /// The sign as written, `+` or `-`.
    pub sign: Option<u8>,
    /// How many digits are written.
    pub digits: u16,
    /// What is wrong with the number itself, if anything.
    pub(crate) fault: NumberFault,
    /// The number in least input increments for a dimension word, as written for any other; `None` where it cannot
    /// be told.
    pub value: Option<i64>,
    pub(crate) from: u32,
    pub(crate) to: u32,
}

impl Word {
    /// Bytes from the start of its block, without tabs.
    pub fn range(&self) -> Range<usize> {
        self.from as usize..self.to as usize
    }

    /// It is a sequence number word: N or `:`.
    pub fn is_sequence(&self) -> bool {
        matches!(self.address, b'N' | b':')
    }

    /// The address for a message.
    pub fn letter(&self) -> char {
        if self.address == 0 { '?' } else { char::from(self.address) }
    }

    /// The number of a two-digit function; `None` if there is none or it has another address.
    pub(crate) fn function(&self, address: u8) -> Option<u8> {
        (self.address == address).then_some(self.value?).and_then(|value| u8::try_from(value).ok())
    }
}
