//! A whole tape as the rules see it.

use crate::execute::Execution;
use crate::format::Control;
use crate::read::{Block, Reading, Traits, Word};
use std::ops::Range;

/// A tape that was read and executed.
pub(crate) struct TapeView<'a> {
    pub text: &'a str,
    pub control: &'a Control,
    pub reading: &'a Reading,
    pub execution: &'a Execution,
    /// The tape executed with the optional block skip switch the other way; only where a block can be skipped.
    pub other: Option<&'a Execution>,
    /// What is in any block: a rule that looks for something else has nothing to do.
    pub seen: Traits,
}

impl TapeView<'_> {
    /// All words with their blocks.
    pub(crate) fn words(&self) -> impl Iterator<Item = (&Block, &Word)> {
        self.reading.blocks.iter().flat_map(|block| self.reading.words(block).iter().map(move |word| (block, word)))
    }

    /// A program with its end, M02 or M30, goes from a block or one before it up to another block.
    pub(crate) fn ends_program(&self, blocks: Range<usize>) -> bool {
        let ends = &self.execution.ends;
        let end = ends.get(ends.partition_point(|end| end.0 < blocks.start));
        end.is_some_and(|&(last, ended)| ended && last < blocks.end)
    }

    /// The text ends in a comment that nothing closes.
    pub(crate) fn ends_in_comment(&self) -> bool {
        self.reading.ends_in_comment()
    }

    /// Where a word stands in the text.
    pub(crate) fn range(&self, block: &Block, word: &Word) -> Range<usize> {
        self.reading.range(block, word)
    }

    /// From the first to the last word of a block; the whole block where it has none.
    pub(crate) fn extent(&self, index: usize) -> Range<usize> {
        let block = &self.reading.blocks[index];
        match self.reading.words(block) {
            [] => block.range.clone(),
            words @ [first, ..] => {
                let last = words.last().unwrap_or(first);
                self.range(block, first).start..self.range(block, last).end
            }
        }
    }

    /// From the first to the last interpolation parameter of a block; the whole block where it has none.
    pub(crate) fn parameters(&self, index: usize) -> Range<usize> {
        let block = &self.reading.blocks[index];
        let mut parameters = self.reading.words(block).iter().filter(|word| matches!(word.address, b'I' | b'J' | b'K'));
        match parameters.next() {
            None => self.extent(index),
            Some(first) => {
                let last = parameters.next_back().unwrap_or(first);
                self.range(block, first).start..self.range(block, last).end
            }
        }
    }

    /// A word of a block, by its place there, and where it stands in the text.
    pub(crate) fn word(&self, index: usize, place: usize) -> Option<(Range<usize>, &Word)> {
        let block = &self.reading.blocks[index];
        self.reading.words(block).get(place).map(|word| (self.range(block, word), word))
    }

    /// The word of a block that gives a function; the whole block where none does.
    pub(crate) fn function(&self, index: usize, address: u8, code: u8) -> Range<usize> {
        let block = &self.reading.blocks[index];
        let word = self.reading.words(block).iter().find(|word| word.function(address) == Some(code));
        word.map_or_else(|| self.extent(index), |word| self.range(block, word))
    }

    /// The blocks with a sequence number that can be told, and it.
    pub(crate) fn sequence_numbers(&self) -> impl Iterator<Item = (usize, i64)> {
        self.reading.blocks.iter().enumerate().filter_map(|(index, block)| Some((index, block.sequence_number()?)))
    }

    /// Where the sequence number word of a block stands.
    pub(crate) fn sequence_range(&self, index: usize) -> Range<usize> {
        let block = &self.reading.blocks[index];
        self.reading.words(block).first().map_or(block.range.clone(), |word| self.range(block, word))
    }

    /// Decimal places with which lengths are said: those of the finest axis that has dimension words.
    pub(crate) fn places(&self) -> usize {
        let written = self.control.axes.iter().filter(|axis| axis.sign.is_some());
        written.map(|axis| usize::from(axis.decimals)).max().unwrap_or(3)
    }
}
