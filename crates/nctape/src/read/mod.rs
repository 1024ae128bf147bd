//! From the text to words and blocks (3.1 to 3.3 of both standards).
//!
//! Reading one block is a function of its characters, the control and whether a comment is open where it starts: its
//! words, its strays and its diagnostics count offsets from the block's start. Reading never fails.

mod block;
mod edit;
mod head;
mod label;
pub(crate) mod number;
mod reader;
mod reading;
mod scanner;
mod survey;
mod word;

pub use block::Block;
pub(crate) use block::Traits;
pub(crate) use edit::{Change, Reread};
pub use head::ProgramMark;
pub(crate) use number::NumberFault;
pub(crate) use reader::Found;
pub use reading::{Reading, read};
pub(crate) use scanner::{Stray, StrayKind};
pub use word::Word;

use crate::format::Control;

/// One block as the rules of reading see it. Offsets count from the start of the block.
pub(crate) struct BlockView<'a> {
    pub control: &'a Control,
    /// The characters of the block, end of block included.
    pub text: &'a str,
    pub words: &'a [Word],
    pub strays: &'a [Stray],
    /// The character of the optional block skip at the head of the block.
    pub skip: Option<usize>,
    /// There is a comment in it.
    pub comment: bool,
    /// There is a tab in it, outside comments.
    pub tab: bool,
    /// The first byte of the end-of-block character; `None` where the text ends before it.
    pub end: Option<usize>,
}

impl BlockView<'_> {
    /// The word that an offset stands in.
    pub(crate) fn word_at(&self, offset: usize) -> Option<&Word> {
        let behind = self.words.partition_point(|word| word.range().end <= offset);
        self.words.get(behind).filter(|word| word.range().contains(&offset))
    }

    /// The sequence number word, if it heads the block.
    pub(crate) fn sequence(&self) -> Option<&Word> {
        self.words.first().filter(|word| word.is_sequence())
    }
}
