//! Reading again what an edit touches, and only that.
//!
//! The pieces before the edit stay as they are. Reading starts at the last piece that begins before it and goes on to
//! the first place behind it where a piece began before, too: how a piece is read hangs on the text behind its start
//! alone, so from there on nothing is new but the places.

use super::block::Block;
use super::reader::{Found, Pieces, Place, Reader};
use super::reading::Reading;
use super::survey::Survey;
use crate::format::Control;
use std::ops::Range;

/// Blocks that an open comment has swallowed, as they were read before: one stretch of the text that was not edited
/// since. When the comment is closed they are taken back. The longest stretch is kept, not every one: comments are
/// closed soon after they are opened.
#[derive(Clone, Debug, Default)]
pub(super) struct Swallowed {
    blocks: Vec<Block>,
    found: Vec<Found>,
}

/// Shorter stretches are read again as fast as they are kept.
const WORTH_KEEPING: usize = 64;

/// What an edit did to the text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Change {
    pub at: usize,
    pub removed: usize,
    pub inserted: usize,
}

impl Change {
    /// The place in the old text of a place behind the edit in the new one.
    fn before(self, at: usize) -> Option<usize> {
        (at >= self.at + self.inserted).then(|| at - self.inserted + self.removed)
    }

    /// The place in the new text of a place behind the edit in the old one.
    pub(crate) fn after(self, at: usize) -> usize {
        at + self.inserted - self.removed
    }

    fn shift(self, range: &mut Range<usize>) {
        *range = self.after(range.start)..self.after(range.end);
    }
}

fn words_of(blocks: &[Block]) -> usize {
    blocks.iter().map(|block| block.words.len()).sum()
}

impl Swallowed {
    /// Follows an edit of the text: what it touches is dropped, and the shorter side of what is left. Tells how many
    /// words went.
    fn edit(&mut self, change: Change) -> usize {
        let before = self.blocks.partition_point(|block| block.range.end < change.at);
        let behind = self.blocks.partition_point(|block| block.range.start < change.at + change.removed);
        let stays_put = before >= self.blocks.len() - behind;
        let keep = if stays_put { 0..before } else { behind..self.blocks.len() };
        let dropped = words_of(&self.blocks[..keep.start]) + words_of(&self.blocks[keep.end..]);
        self.keep(keep);
        if !stays_put {
            self.blocks.iter_mut().for_each(|block| change.shift(&mut block.range));
            self.found.iter_mut().for_each(|found| found.origin = change.after(found.origin));
        }
        dropped
    }

    /// Keeps a stretch of the blocks, and what was found in them.
    fn keep(&mut self, stretch: Range<usize>) {
        self.blocks.truncate(stretch.end);
        self.blocks.drain(..stretch.start);
        let (first, last) = (self.blocks.first(), self.blocks.last());
        let range = first.zip(last).map_or(0..0, |(first, last)| first.range.start..last.range.end);
        self.found.retain(|found| range.contains(&found.origin));
    }

    /// The block that begins at a byte of the text.
    fn begins_at(&self, at: usize) -> Option<usize> {
        self.blocks.binary_search_by_key(&at, |block| block.range.start).ok()
    }

    /// Gives the blocks from one on back to a reader that has come to it. Tells how many they were, and how many words
    /// of blocks before them went.
    fn take_back(&mut self, reader: &mut Reader<'_>, first: usize) -> (usize, usize) {
        let dropped = words_of(&self.blocks[..first]);
        self.keep(first..self.blocks.len());
        let Swallowed { blocks, found } = std::mem::take(self);
        let taken = blocks.len();
        for block in blocks {
            reader.at = block.range.end;
            reader.pieces.blocks.push(Block { row: reader.row, program: reader.program, ..block });
            reader.row += block.rows;
        }
        reader.blocks += taken;
        reader.pieces.found.extend(found);
        (taken, dropped)
    }
}

/// From where on the old tables hold: a block, a head and a finding.
struct Tail {
    block: usize,
    head: usize,
    found: usize,
    /// What the old tables say of rows, programs and blocks there.
    row: usize,
    program: u32,
}

/// What of the tables an edit has changed: these blocks were replaced by so many.
#[derive(Clone, Debug)]
pub(crate) struct Reread {
    pub old: Range<usize>,
    pub new: Range<usize>,
}

impl Reading {
    /// Brings the reading up to date with a text that was changed in one place.
    pub(crate) fn edit(&mut self, text: &str, control: &Control, change: Change) -> Reread {
        let (first_head, first_block, at, place) = self.restart(change.at);
        let mut swallowed = std::mem::take(&mut self.swallowed);
        self.dead += swallowed.edit(change);
        let mut words = std::mem::take(&mut self.words);
        let mut reader = Reader::new(text, control, &mut words);
        (reader.at, reader.place, reader.blocks) = (at, Some(place), first_block);
        reader.row = match place {
            Place::Head => self.heads.get(first_head).map_or(0, |head| head.row),
            Place::Block => self.blocks[first_block].row,
        };
        reader.program = first_head.checked_sub(1).map_or(0, |before| self.heads[before].program);
        let (mut taken_back, mut dead) = (0, 0);
        let tail = loop {
            if let Some(tail) = reader.place.and_then(|place| self.meets(change, reader.at, place)) {
                break Some(tail);
            }
            match reader.place {
                None => break None,
                Some(place) => match swallowed.begins_at(reader.at).filter(|_| place == Place::Block) {
                    Some(first) => {
                        let (taken, dropped) = swallowed.take_back(&mut reader, first);
                        taken_back += taken;
                        dead += dropped;
                    }
                    None => reader.read(),
                },
            }
        };
        let Reader { pieces, row, blocks, program, open_comment, .. } = reader;
        self.dead += dead;
        self.last_read = pieces.blocks.len() - taken_back;
        if tail.is_none() {
            self.open_comment = open_comment;
        }
        let end = Tail {
            block: self.blocks.len(),
            head: self.heads.len(),
            found: self.found.len(),
            row: self.rows,
            program: 0,
        };
        let tail = tail.unwrap_or(end);
        self.words = words;
        let reread = Reread { old: first_block..tail.block, new: first_block..first_block + pieces.blocks.len() };
        let (rows, programs) = (row.wrapping_sub(tail.row), program.wrapping_sub(tail.program));
        self.move_tail(&tail, change, rows, programs, blocks.wrapping_sub(tail.block));
        self.rows = self.rows.wrapping_add(rows);
        self.swallowed = swallowed;
        self.replace(pieces, first_head, first_block, at, &tail, change, text.len());
        self.compact();
        self.survey = Survey::of(&self.blocks);
        reread
    }

    /// Where reading starts again: heads and blocks that stay, the byte, and what begins there.
    fn restart(&self, at: usize) -> (usize, usize, usize, Place) {
        // Whether the text begins with a label may hang on what stands far behind it.
        if self.heads.first().is_some_and(|head| at <= head.looked) {
            return (0, 0, 0, Place::Head);
        }
        let head = self.heads.partition_point(|head| head.start < at).saturating_sub(1);
        let first = self.heads.get(head).map_or(0, |head| head.blocks_before);
        match self.blocks.partition_point(|block| block.range.start < at).checked_sub(1) {
            // How far a head goes may hang on a comment that the edit closes: the first block is read with its head.
            Some(block) if block > first => (head + 1, block, self.blocks[block].range.start, Place::Block),
            _ => (head, first, self.heads.get(head).map_or(0, |head| head.start), Place::Head),
        }
    }

    /// The rest of the old tables, where a place behind the edit is one at which the same kind of piece began before.
    fn meets(&self, change: Change, at: usize, place: Place) -> Option<Tail> {
        let old = change.before(at)?;
        let found = || self.found.partition_point(|found| found.origin < old);
        match place {
            Place::Block => {
                let block = self.blocks.binary_search_by_key(&old, |block| block.range.start).ok()?;
                let head = self.heads.partition_point(|head| head.start <= old);
                let Block { row, program, .. } = self.blocks[block];
                Some(Tail { block, head, found: found(), row, program })
            }
            Place::Head => {
                let head = self.heads.binary_search_by_key(&old, |head| head.start).ok()?;
                let program = head.checked_sub(1).map_or(0, |before| self.heads[before].program);
                let it = &self.heads[head];
                Some(Tail { block: it.blocks_before, head, found: found(), row: it.row, program })
            }
        }
    }

    fn move_tail(&mut self, tail: &Tail, change: Change, rows: usize, programs: u32, blocks: usize) {
        if change.inserted == change.removed && rows == 0 && programs == 0 && blocks == 0 {
            return;
        }
        for block in &mut self.blocks[tail.block..] {
            change.shift(&mut block.range);
            block.row = block.row.wrapping_add(rows);
            block.program = block.program.wrapping_add(programs);
        }
        for head in &mut self.heads[tail.head..] {
            head.start = change.after(head.start);
            head.looked = change.after(head.looked);
            head.row = head.row.wrapping_add(rows);
            head.blocks_before = head.blocks_before.wrapping_add(blocks);
            head.program = head.program.wrapping_add(programs);
            if let Some((mark, number)) = &mut head.mark {
                change.shift(mark);
                change.shift(number);
            }
        }
        for found in &mut self.found[tail.found..] {
            found.origin = change.after(found.origin);
        }
    }

    /// Puts the pieces that were read in the place of those that they replace.
    #[expect(clippy::too_many_arguments, reason = "the ends of three tables")]
    fn replace(
        &mut self,
        pieces: Pieces,
        first_head: usize,
        first_block: usize,
        start: usize,
        tail: &Tail,
        change: Change,
        length: usize,
    ) {
        let first_found = self.found.partition_point(|found| found.origin < start);
        let found: Vec<Found> = self.found.splice(first_found..tail.found, pieces.found).collect();
        let heads: Vec<_> = self.heads.splice(first_head..tail.head, pieces.heads).collect();
        let blocks = self.blocks.splice(first_block..tail.block, pieces.blocks);
        // Those that the edit did not touch, up to where another program begins.
        let behind = change.at + change.removed;
        let length = length + change.removed - change.inserted;
        let next = heads.iter().map(|head| head.start).find(|&start| start >= behind).unwrap_or(usize::MAX);
        let (mut dead, mut kept) = (0, Vec::new());
        for mut block in blocks {
            // The last block of the text may go on when the text does.
            if block.range.start >= behind && block.range.end <= next && block.range.end < length {
                change.shift(&mut block.range);
                kept.push(block);
            } else {
                dead += block.words.len();
            }
        }
        self.dead += dead;
        if kept.len() < WORTH_KEEPING || kept.len() < self.swallowed.blocks.len() {
            self.dead += words_of(&kept);
            return;
        }
        self.dead += words_of(&self.swallowed.blocks);
        let from = kept[0].range.start;
        let to = kept[kept.len() - 1].range.end;
        let mut found = found;
        found.retain_mut(|found| {
            let moved = found.origin >= behind;
            if moved {
                found.origin = change.after(found.origin);
            }
            moved && (from..to).contains(&found.origin)
        });
        self.swallowed = Swallowed { blocks: kept, found };
    }

    /// Puts the words in order again when most of them belong to no block.
    fn compact(&mut self) {
        if self.dead * 2 <= self.words.len() {
            return;
        }
        let mut words = Vec::with_capacity(self.words.len() - self.dead);
        for block in self.blocks.iter_mut().chain(&mut self.swallowed.blocks) {
            let first = words.len() as u32;
            words.extend_from_slice(&self.words[block.words.start as usize..block.words.end as usize]);
            block.words = first..words.len() as u32;
        }
        self.words = words;
        self.dead = 0;
    }
}
