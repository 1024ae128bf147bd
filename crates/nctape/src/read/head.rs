//! What stands before the first block of a program.

use super::{Stray, StrayKind};
use crate::format::Control;
use crate::text::{Listing, Mark};
use std::ops::Range;

/// A program start character `%`, with the program number behind it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramMark {
    /// The character.
    pub range: Range<usize>,
    /// The digits behind it; empty where there are none.
    pub number: Range<usize>,
    /// Blocks before it.
    pub blocks_before: usize,
    /// The last block before it that has a word.
    pub word_before: Option<usize>,
    /// An end-of-block character stands before it.
    pub behind_end_of_block: bool,
}

/// What stands before the first block of a program: comments, the program start character with its number, and the
/// leading end of block.
#[derive(Clone, Debug)]
pub(super) struct Head {
    pub start: usize,
    /// The first row of it on the tape.
    pub row: usize,
    /// Its program start character and the number behind it.
    pub mark: Option<(Range<usize>, Range<usize>)>,
    /// It ends with an end of block.
    pub led: bool,
    pub blocks_before: usize,
    /// Program start characters up to here, its own included.
    pub program: u32,
}

/// What was read of a head.
pub(super) struct ReadHead {
    pub mark: Option<(Range<usize>, Range<usize>)>,
    pub led: bool,
    /// The byte where the first block starts.
    pub end: usize,
}

/// Reads the head that starts at byte `start`, adding what no code has a row for to `strays`.
pub(super) fn read_head(text: &str, start: usize, control: &Control, strays: &mut Vec<Stray>) -> ReadHead {
    let mut head = ReadHead { mark: None, led: false, end: start };
    let mut number_may_follow = false;
    let mut open = false;
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
                head.end = character.to;
                head.led = true;
                break;
            }
            Mark::Character('%') if head.mark.is_none() => {
                number_may_follow = true;
                head.mark = Some((character.from..character.to, character.to..character.to));
            }
            Mark::Character('0'..='9') if number_may_follow => {
                if let Some((_, number)) = &mut head.mark {
                    let start = if number.start == number.end { character.from } else { number.start };
                    *number = start..character.to;
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
        head.end = character.to;
    }
    if open {
        strays.retain(|stray| start + (stray.from as usize) < head.end);
    }
    head
}
