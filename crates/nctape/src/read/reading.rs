//! What was read of a whole text, as flat tables.

use super::block::Block;
use super::edit::Swallowed;
use super::head::{Head, ProgramMark};
use super::reader::{Found, Reader};
use super::survey::Survey;
use super::word::Word;
use crate::code::{Code, EndOfBlock, Rows, encode_from};
use crate::format::Control;
use std::ops::Range;

/// What was read of a text.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// The blocks, in order.
    pub blocks: Vec<Block>,
    pub(super) heads: Vec<Head>,
    pub(super) found: Vec<Found>,
    /// The words of all blocks, wherever a block's own may stand, and those of blocks that are gone.
    pub(super) words: Vec<Word>,
    /// How many of them belong to no block any more.
    pub(super) dead: usize,
    pub(super) swallowed: Swallowed,
    pub(super) rows: usize,
    pub(super) open_comment: bool,
    pub(super) last_read: usize,
    pub(super) survey: Survey,
}

/// Reads a text against a control.
pub fn read(text: &str, control: &Control) -> Reading {
    // Room for as many as a tape of plain blocks has, so that the tables need not grow piece by piece: a word of six
    // characters, a block of five words.
    let mut words = Vec::with_capacity(text.len() / 6);
    let mut reader = Reader::new(text, control, &mut words);
    reader.pieces.blocks.reserve(text.len() / 30);
    while reader.place.is_some() {
        reader.read();
    }
    let Reader { pieces, row, open_comment, .. } = reader;
    Reading {
        last_read: pieces.blocks.len(),
        survey: Survey::of(&pieces.blocks),
        blocks: pieces.blocks,
        heads: pieces.heads,
        found: pieces.found,
        words,
        dead: 0,
        swallowed: Swallowed::default(),
        rows: row,
        open_comment,
    }
}

impl Reading {
    /// The words of a block. Their offsets count from its start.
    pub fn words(&self, block: &Block) -> &[Word] {
        &self.words[block.words.start as usize..block.words.end as usize]
    }

    /// How many words the blocks have.
    pub fn word_count(&self) -> usize {
        self.blocks.iter().map(|block| block.words.len()).sum()
    }

    /// Where a word of a block stands in the text.
    pub fn range(&self, block: &Block, word: &Word) -> Range<usize> {
        block.range.start + word.range().start..block.range.start + word.range().end
    }

    /// The block that a byte of the text belongs to.
    pub fn block_at(&self, offset: usize) -> Option<usize> {
        let behind = self.blocks.partition_point(|block| block.range.start <= offset);
        let index = behind.checked_sub(1)?;
        (offset < self.blocks[index].range.end).then_some(index)
    }

    /// The block that a row of the tape belongs to.
    pub fn block_of_row(&self, row: usize) -> Option<usize> {
        let index = self.blocks.partition_point(|block| block.row <= row).checked_sub(1)?;
        let block = &self.blocks[index];
        (row < block.row + block.rows).then_some(index)
    }

    /// The program start characters, in order.
    pub fn programs(&self) -> impl Iterator<Item = ProgramMark> {
        let (mut led, mut seen, mut word_before) = (false, 0, None);
        self.heads.iter().filter_map(move |head| {
            let blocks_before = head.blocks_before;
            let behind_end_of_block = led || blocks_before > 0;
            led |= head.led;
            let worded = (seen..blocks_before).rfind(|&index| !self.blocks[index].words.is_empty());
            (seen, word_before) = (blocks_before, worded.or(word_before));
            let (range, number) = head.mark.clone()?;
            Some(ProgramMark { range, number, blocks_before, word_before, behind_end_of_block })
        })
    }

    /// The byte where the program with a number begins: its program start character.
    pub(crate) fn program_start(&self, program: u32) -> usize {
        let head = self.heads.partition_point(|head| head.program < program);
        self.heads.get(head).map_or(0, |head| head.start)
    }

    /// For each program whose first block is not preceded by an end of block, that block. One without a word gives the
    /// end of block to those behind it.
    pub(crate) fn unled(&self) -> impl Iterator<Item = usize> {
        let next = self.heads.iter().skip(1).map(|head| head.blocks_before).chain([self.blocks.len()]);
        let heads = self.heads.iter().zip(next);
        let first = heads.filter(|(head, next)| !head.led && head.blocks_before < *next);
        first.map(|(head, _)| head.blocks_before).filter(|&first| !self.blocks[first].words.is_empty())
    }

    /// The stretches of a text of some length that belong to no block.
    pub(crate) fn between_blocks(&self, length: usize) -> impl Iterator<Item = Range<usize>> {
        let end = |blocks: usize| blocks.checked_sub(1).map_or(0, |last| self.blocks[last].range.end);
        let next = move |blocks: usize| self.blocks.get(blocks).map_or(length, |block| block.range.start);
        let counts = self.heads.iter().map(|head| head.blocks_before).chain([self.blocks.len()]);
        // Heads without a block between them share a stretch.
        let mut last = None;
        let counts = counts.filter(move |&blocks| last.replace(blocks) != Some(blocks));
        counts.map(move |blocks| end(blocks)..next(blocks))
    }

    /// What the rules of reading found, in order.
    pub(crate) fn found(&self) -> &[Found] {
        &self.found
    }

    /// The text ends in a comment that nothing closes.
    pub(crate) fn ends_in_comment(&self) -> bool {
        self.open_comment
    }

    /// What one pass over all blocks tells.
    pub(crate) fn survey(&self) -> Survey {
        self.survey
    }

    /// How many blocks the last edit, or the first reading, has read.
    pub(crate) fn last_read(&self) -> usize {
        self.last_read
    }

    /// How many rows the tape has.
    pub fn row_count(&self) -> usize {
        self.rows
    }

    /// Rows of the tape: at most `count`, from row `first` on.
    pub fn rows(&self, text: &str, code: Code, end_of_block: EndOfBlock, first: usize, count: usize) -> Rows {
        let (at, row) = self.last_joint(|_, row| row <= first);
        encode_from(text, at, code, end_of_block, first - row.min(first), count)
    }

    /// The row whose character stands at or behind a byte of the text.
    pub fn row_at(&self, text: &str, code: Code, offset: usize) -> usize {
        let (at, row) = self.last_joint(|at, _| at <= offset);
        let before = crate::text::Listing::resume(text, at, false).take_while(|it| it.from < offset);
        row + before.filter(|it| it.has_row(code)).count()
    }

    /// The last place where a piece begins or a block ends, byte and row, of those that `reached` holds for; it holds for
    /// all up to some place.
    fn last_joint(&self, reached: impl Fn(usize, usize) -> bool) -> (usize, usize) {
        let block = self.blocks.partition_point(|block| reached(block.range.start, block.row)).checked_sub(1);
        let head = self.heads.partition_point(|head| reached(head.start, head.row)).checked_sub(1);
        let block = block.map_or((0, 0), |index| {
            let block = &self.blocks[index];
            let end = (block.range.end, block.row + block.rows);
            if reached(end.0, end.1) { end } else { (block.range.start, block.row) }
        });
        head.map_or(block, |index| block.max((self.heads[index].start, self.heads[index].row)))
    }
}
