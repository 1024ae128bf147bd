//! One block, and what the rules on a whole tape ask of it without looking at its words.

use super::word::Word;
use std::ops::Range;

/// One block: its place in the text and its words.
#[derive(Clone, Debug)]
pub struct Block {
    /// Bytes of the text, the end-of-block character included (3.2.1).
    pub range: Range<usize>,
    /// The optional block skip character heads it.
    pub skip: bool,
    /// It stands behind this many program start characters.
    pub program: u32,
    /// The row of its first character on the tape.
    pub row: usize,
    /// How many rows it has.
    pub rows: usize,
    pub(super) words: Range<u32>,
    pub(crate) traits: Traits,
    pub(super) number: i64,
}

/// No sequence number: no word can say it, a number has 18 digits at most.
const NO_NUMBER: i64 = i64::MIN;

impl Block {
    pub(super) fn new(range: Range<usize>, words: &[Word], at: Range<u32>, traits: Traits) -> Block {
        let number = words.first().filter(|word| word.is_sequence()).and_then(|word| word.value);
        let traits = words.iter().fold(traits, |traits, word| traits.with_word(word));
        let number = number.unwrap_or(NO_NUMBER);
        Block { range, skip: false, program: 0, row: 0, rows: 0, words: at, traits, number }
    }

    /// The sequence number, where the block begins with one that can be told.
    pub(crate) fn sequence_number(&self) -> Option<i64> {
        (self.number != NO_NUMBER).then_some(self.number)
    }
}

/// What is in a block, a bit each: so a rule passes over the blocks that do not concern it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Traits(u64);

impl Traits {
    /// It has a tab.
    pub(crate) const TAB: Traits = Traits(1 << 32);
    /// An address is written in lower case.
    pub(crate) const LOWER_CASE: Traits = Traits(1 << 33);
    /// A decimal sign stands in a number.
    pub(crate) const DECIMAL_SIGN: Traits = Traits(1 << 34);
    /// It has more than one feed word, or one before a dimension word: their places want a look.
    pub(crate) const FEED_PLACES: Traits = Traits(1 << 35);

    /// It has a word with this address: a capital letter or `:`.
    pub(crate) const fn address(address: u8) -> Traits {
        match address {
            b'A'..=b'Z' => Traits(1 << (address - b'A')),
            b':' => Traits(1 << 26),
            _ => Traits(1 << 27),
        }
    }

    /// It has any of these.
    pub(crate) fn any(self, other: Traits) -> bool {
        self.0 & other.0 != 0
    }

    pub(crate) const fn with(self, other: Traits) -> Traits {
        Traits(self.0 | other.0)
    }

    fn with_word(self, word: &Word) -> Traits {
        let lower_case = if word.lower_case { Traits::LOWER_CASE } else { Traits(0) };
        let decimal = matches!(word.fault, super::NumberFault::DecimalSign(_));
        let decimal = if decimal { Traits::DECIMAL_SIGN } else { Traits(0) };
        self.with(Traits::address(word.address)).with(lower_case).with(decimal)
    }
}
