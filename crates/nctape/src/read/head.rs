//! What stands before the first block of a program.

use super::{Stray, StrayKind, label};
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
    /// How far the text was looked at to tell a label from a block.
    pub looked: usize,
    pub blocks_before: usize,
    /// Program start characters up to here, its own included.
    pub program: u32,
}

/// What was read of a head.
pub(super) struct ReadHead {
    pub mark: Option<(Range<usize>, Range<usize>)>,
    pub led: bool,
    pub looked: usize,
    /// The byte where the first block starts.
    pub end: usize,
}

/// Reads the head that starts at byte `start`, adding what no code has a row for to `strays`.
pub(super) fn read_head(text: &str, start: usize, control: &Control, strays: &mut Vec<Stray>) -> ReadHead {
    let mut head = ReadHead { mark: None, led: false, looked: start, end: start };
    let mut number_may_follow = false;
    let mut open = false;
    let mut listing = Listing::resume(text, start, false);
    while let Some(character) = listing.next() {
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
            Mark::Character(_) => {
                let (label, looked) = label::read(text, character.from, head.mark.is_none());
                head.looked = head.looked.max(looked);
                let Some(end) = label else { break };
                let shown = character.from..character.from + text[character.from..end].trim_end().len();
                push_label(&text[shown.clone()], shown.start - start, head.mark.is_some(), control, strays);
                number_may_follow = false;
                head.end = end;
                listing = Listing::resume(text, end, false);
                continue;
            }
        }
        head.end = character.to;
    }
    if open {
        strays.retain(|stray| start + (stray.from as usize) < head.end);
    }
    head
}

/// Notes a label. Before the program start a control passes over it; characters that the code lacks are what is wrong
/// with it then.
fn push_label(label: &str, at: usize, behind_start: bool, control: &Control, strays: &mut Vec<Stray>) {
    let mut push = |kind, from: usize, to: usize| strays.push(Stray { kind, from: from as u32, to: to as u32 });
    if behind_start {
        push(StrayKind::LabelBehindStart, at, at + label.len());
        return;
    }
    let layout = |character: char| matches!(character, '\n' | '\r' | '*');
    let lacking = label.char_indices().filter(|&(_, c)| control.code.row(c).is_none() && !layout(c));
    let mut lacking = lacking.peekable();
    if lacking.peek().is_none() {
        push(StrayKind::Label, at, at + label.len());
    }
    lacking.for_each(|(from, c)| push(StrayKind::Foreign(c), at + from, at + from + c.len_utf8()));
}
