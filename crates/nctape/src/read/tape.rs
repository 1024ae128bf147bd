//! A whole text: what stands before the first block, and its blocks.

use super::scanner::{BlockEnd, scan};
use super::word::Word;
use super::{BlockView, Stray, StrayKind};
use crate::diagnostic::{Diagnostic, Sink};
use crate::format::Control;
use crate::rules;
use crate::text::{Listing, Mark};
use std::ops::Range;

/// One block: its place in the text and its words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Bytes of the text, the end-of-block character included (3.2.1).
    pub range: Range<usize>,
    /// The optional block skip character heads it.
    pub skip: bool,
    /// It stands behind this many program start characters.
    pub program: u32,
    words: Range<u32>,
}

/// A program start character `%`, with the program number behind it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramMark {
    /// The character.
    pub range: Range<usize>,
    /// The digits behind it; empty where there are none.
    pub number: Range<usize>,
    /// Blocks before it.
    pub blocks_before: usize,
    /// An end-of-block character stands before it.
    pub behind_end_of_block: bool,
}

/// What was read of a text.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// The blocks, in order.
    pub blocks: Vec<Block>,
    /// The words of all blocks, in order.
    pub words: Vec<Word>,
    /// The program start characters.
    pub programs: Vec<ProgramMark>,
    /// For each program whose first block is not preceded by an end of block, that block.
    pub unled: Vec<usize>,
    /// What the rules of reading found.
    pub diagnostics: Vec<Diagnostic>,
}

impl Reading {
    /// The words of a block. Their offsets count from its start.
    pub fn words(&self, block: &Block) -> &[Word] {
        &self.words[block.words.start as usize..block.words.end as usize]
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
}

/// Reads a text against a control.
pub fn read(text: &str, control: &Control) -> Reading {
    let mut reading = Reading::default();
    let mut strays: Vec<Stray> = Vec::new();
    let mut at = 0;
    let mut ends = 0;
    loop {
        let led = read_head(text, &mut at, &mut ends, control, &mut reading);
        let first = reading.blocks.len();
        let program = reading.programs.len() as u32;
        let end = loop {
            let first_word = reading.words.len();
            let first_finding = reading.diagnostics.len();
            strays.clear();
            let scanned = scan(text, at, control, &mut reading.words, &mut strays);
            let start = std::mem::replace(&mut at, scanned.next);
            let characters = &text[start..at];
            let has_words = reading.words.len() > first_word;
            let ended = matches!(scanned.end, BlockEnd::EndOfBlock(_));
            let empty = !has_words && strays.is_empty() && scanned.skip.is_none() && !scanned.comment;
            if !ended && empty && (scanned.end == BlockEnd::ProgramStart || characters.trim().is_empty()) {
                break scanned.end;
            }
            let view = BlockView {
                control,
                text: characters,
                words: &reading.words[first_word..],
                strays: &strays,
                skip: scanned.skip,
                end: match scanned.end {
                    BlockEnd::EndOfBlock(byte) => Some(byte - start),
                    _ => None,
                },
            };
            rules::check_block(&view, &mut Sink::new(control.standard(), &mut reading.diagnostics));
            reading.diagnostics[first_finding..].iter_mut().for_each(|found| found.shift(start));
            // What follows the last end of block without a word is no block: a comment, or layout.
            if has_words || ended {
                reading.blocks.push(Block {
                    range: start..at,
                    skip: scanned.skip.is_some(),
                    program,
                    words: first_word as u32..reading.words.len() as u32,
                });
            }
            match scanned.end {
                BlockEnd::EndOfBlock(_) => ends += 1,
                other => break other,
            }
        };
        if !led && reading.blocks.len() > first {
            reading.unled.push(first);
        }
        if end == BlockEnd::Text {
            return reading;
        }
    }
}

/// Reads what stands before the first block of a program: comments, the program start character with its number and
/// the leading end of block. Tells whether there was one.
fn read_head(text: &str, at: &mut usize, ends: &mut usize, control: &Control, reading: &mut Reading) -> bool {
    let start = *at;
    let mut strays = Vec::new();
    let mut marked = false;
    let mut number_may_follow = false;
    let mut open = false;
    let mut led = false;
    for character in Listing::resume(text, start, false) {
        match character.mark {
            Mark::Character(c) if character.comment => {
                if control.code.row(c).is_none() {
                    let (from, to) = (character.from - start, character.to - start);
                    strays.push(Stray { kind: StrayKind::InComment(c), from: from as u32, to: to as u32 });
                }
                continue;
            }
            Mark::EndOfBlock if character.comment => continue,
            Mark::EndOfBlock => {
                *at = character.to;
                *ends += 1;
                led = true;
                break;
            }
            Mark::Character('%') if !marked => {
                marked = true;
                number_may_follow = true;
                reading.programs.push(ProgramMark {
                    range: character.from..character.to,
                    number: character.to..character.to,
                    blocks_before: reading.blocks.len(),
                    behind_end_of_block: *ends > 0,
                });
            }
            Mark::Character('0'..='9') if number_may_follow => {
                if let Some(mark) = reading.programs.last_mut() {
                    mark.number.end = character.to;
                }
            }
            Mark::Character('(') => {
                // A comment that nothing closes is left to the reader of blocks, which reports it.
                open = true;
                number_may_follow = false;
                continue;
            }
            Mark::Character(')') if open => open = false,
            Mark::Character(_) => break,
        }
        *at = character.to;
    }
    if open {
        strays.retain(|stray| start + (stray.from as usize) < *at);
    }
    let first = reading.diagnostics.len();
    rules::check_head(&strays, control, &mut Sink::new(control.standard(), &mut reading.diagnostics));
    reading.diagnostics[first..].iter_mut().for_each(|found| found.shift(start));
    led
}
