//! What executing a tape gave, and how it is brought up to date after an edit.
//!
//! Every few hundred blocks a mark keeps what the control carries on. After an edit executing begins at the last mark
//! before it, and ends where it comes to a mark with the same in hand as before: from there on nothing is new but the
//! numbers of the blocks. Under incremental dimensions every later position moves with the edit; then it goes to the end.

use super::event::{Event, EventKind};
use super::mark::{Carried, Lengths, Mark};
use super::section::{Section, Starved};
use super::state::State;
use super::totals::{Bounds, Totals};
use super::walk::{Fate, Walk};
use super::{Held, run_block};
use crate::format::Control;
use crate::read::{Reading, Reread, Traits};
use crate::span::Spans;

/// Blocks between two marks: an edit costs about as many to execute, and a mark weighs some 300 bytes.
const BETWEEN_MARKS: usize = 256;

/// What executing a tape gave.
#[derive(Clone, Debug, Default)]
pub struct Execution {
    /// The spans, in order.
    pub spans: Spans,
    /// Lengths and times.
    pub totals: Totals,
    /// The room that the path takes; `None` where nothing moves.
    pub bounds: Option<Bounds>,
    /// What could not be done as written.
    pub(crate) events: Vec<Event>,
    /// Blocks that no one executes, because an end of program stands before them.
    pub(crate) unreached: Vec<usize>,
    /// For each program that was executed, its last block and whether it is an end of program.
    pub(crate) ends: Vec<(usize, bool)>,
    /// What the control holds behind executed blocks that cannot be skipped, beside those that can.
    pub(crate) held: Vec<(usize, Held)>,
    /// The executed blocks that have a miscellaneous function.
    pub(crate) miscellaneous: Vec<usize>,
    /// The spans that are cut faster than they are read.
    pub(crate) starved: Starved,
    marks: Vec<Mark>,
    last_executed: usize,
    last_kept: Kept,
}

/// Which spans an edit has left as they were, but for the numbers of their blocks: so many at the start and at the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kept {
    /// So many of the first ones.
    pub first: usize,
    /// So many of the last ones.
    pub last: usize,
}

/// Executes what was read. `skip` is the position of the optional block skip switch.
pub(crate) fn execute(reading: &Reading, control: &Control, skip: bool) -> Execution {
    let mut execution =
        Execution { spans: Spans::new(control.axes.len(), control.compensates()), ..Execution::default() };
    let everything = Reread { old: 0..0, new: 0..reading.blocks.len() };
    execution.edit(reading, control, skip, &everything);
    execution
}

impl Execution {
    /// Brings it up to date with blocks that were read again.
    pub(crate) fn edit(&mut self, reading: &Reading, control: &Control, skip: bool, reread: &Reread) {
        // The block before the first new one may be told to hold something: see `Run::hold`.
        let first = self.marks.partition_point(|mark| mark.block < reread.old.start).checked_sub(1);
        let start = first.map(|first| self.marks[first]);
        // At first a span for each block, mostly; later only what an edit changes.
        let room = if self.spans.list.is_empty() { reading.blocks.len() } else { 2 * BETWEEN_MARKS };
        let mut run = Run::new(reading, control, skip, start, self.spans.empty(room));
        let base = start.map_or(Lengths::default(), |mark| mark.lengths);
        let shift = reread.new.end.wrapping_sub(reread.old.end);
        let old = self.marks.partition_point(|mark| mark.block <= reread.old.end);
        let met = run.until(&self.marks[old..], shift).map(|met| old + met);
        self.last_executed = run.index - start.map_or(0, |mark| mark.block);

        let spans_before = self.spans.list.len();
        let met_mark = met.map(|met| self.marks[met]);
        let end = met_mark.map_or(self.lengths(), |mark| mark.lengths);
        let added = run.lengths();
        let Run { state, unreached, ends, held, miscellaneous, mut marks, .. } = run;
        self.spans.splice(base.spans..end.spans, state.spans);
        self.last_kept = Kept { first: base.spans, last: spans_before - end.spans };
        self.events.splice(base.events..end.events, state.events);
        self.unreached.splice(base.unreached..end.unreached, unreached);
        self.ends.splice(base.ends..end.ends, ends);
        self.held.splice(base.held..end.held, held);
        self.miscellaneous.splice(base.miscellaneous..end.miscellaneous, miscellaneous);
        for mark in &mut marks {
            mark.lengths = mark.lengths.plus(base);
        }
        let kept = first.map_or(0, |first| first + 1);
        let moved = base.plus(added);
        let met = met.unwrap_or(self.marks.len());
        for mark in &mut self.marks[met..] {
            mark.block = mark.block.wrapping_add(shift);
            if let Some(pending) = &mut mark.carried.pending {
                pending.block = pending.block.wrapping_add(shift);
                pending.last = pending.last.wrapping_add(shift);
            }
            mark.lengths = mark.lengths.moved(end, moved);
        }
        let added_marks = marks.len();
        self.marks.splice(kept..met, marks);
        if shift != 0 {
            self.move_blocks(moved, shift);
        }
        self.measure(kept, added_marks, moved.spans.wrapping_sub(end.spans), reading, control);
        self.totals = Totals::of(self.spans.shares());
        let left_out = self.events.iter().any(|event| matches!(event.kind, EventKind::LeftOut));
        self.totals.seconds = self.totals.seconds.filter(|_| !left_out);
    }

    /// What is known of the spans between the marks: anew for the marks that were set and the one behind them, as kept
    /// for the others, the spans of which have moved by `shift`.
    fn measure(&mut self, first: usize, count: usize, shift: usize, reading: &Reading, control: &Control) {
        let reader_speed = control.format.reader_speed();
        let spans = &self.spans.list;
        let section = |from: usize, to: usize| Section::of(&spans[from..to], from, &reading.blocks, reader_speed);
        let mut from = first.checked_sub(1).map_or(0, |before| self.marks[before].lengths.spans);
        for (place, mark) in self.marks.iter_mut().enumerate().skip(first) {
            let to = mark.lengths.spans;
            mark.section = if place <= first + count { section(from, to) } else { mark.section.moved(shift) };
            from = to;
        }
        let rest = section(from, spans.len());
        let whole = self.marks.iter().map(|mark| mark.section).chain([rest]).reduce(Section::with);
        let Section { bounds, starved } = whole.unwrap_or_default();
        (self.bounds, self.starved) = (bounds, starved);
    }

    /// Gives the blocks of what follows the lengths their new numbers.
    fn move_blocks(&mut self, from: Lengths, shift: usize) {
        for span in &mut self.spans.list[from.spans..] {
            span.blocks = (span.blocks.0.wrapping_add(shift), span.blocks.1.wrapping_add(shift));
        }
        self.events[from.events..].iter_mut().for_each(|event| event.block = event.block.wrapping_add(shift));
        self.unreached[from.unreached..].iter_mut().for_each(|block| *block = block.wrapping_add(shift));
        self.ends[from.ends..].iter_mut().for_each(|end| end.0 = end.0.wrapping_add(shift));
        self.held[from.held..].iter_mut().for_each(|held| held.0 = held.0.wrapping_add(shift));
        self.miscellaneous[from.miscellaneous..].iter_mut().for_each(|block| *block = block.wrapping_add(shift));
    }

    fn lengths(&self) -> Lengths {
        Lengths {
            spans: self.spans.list.len(),
            events: self.events.len(),
            unreached: self.unreached.len(),
            ends: self.ends.len(),
            held: self.held.len(),
            miscellaneous: self.miscellaneous.len(),
        }
    }

    /// Which spans the last edit has left as they were; none at first.
    pub(crate) fn last_kept(&self) -> Kept {
        self.last_kept
    }

    /// The last mark at or before a block.
    pub(super) fn mark_before(&self, block: usize) -> Option<&Mark> {
        self.marks[..self.marks.partition_point(|mark| mark.block <= block)].last()
    }

    /// How many blocks were executed by the last edit, or at first.
    pub(crate) fn last_executed(&self) -> usize {
        self.last_executed
    }
}

impl Lengths {
    fn plus(self, other: Lengths) -> Lengths {
        self.each(other, |this, other| this + other)
    }

    /// Where what stood at `from` stands at `to`.
    fn moved(self, from: Lengths, to: Lengths) -> Lengths {
        self.each(from, |this, from| this - from).plus(to)
    }

    fn each(self, other: Lengths, combine: impl Fn(usize, usize) -> usize) -> Lengths {
        Lengths {
            spans: combine(self.spans, other.spans),
            events: combine(self.events, other.events),
            unreached: combine(self.unreached, other.unreached),
            ends: combine(self.ends, other.ends),
            held: combine(self.held, other.held),
            miscellaneous: combine(self.miscellaneous, other.miscellaneous),
        }
    }
}

/// Executing from one block on.
struct Run<'a> {
    reading: &'a Reading,
    state: State<'a>,
    /// The block to be executed next.
    index: usize,
    walk: Walk,
    unreached: Vec<usize>,
    ends: Vec<(usize, bool)>,
    held: Vec<(usize, Held)>,
    miscellaneous: Vec<usize>,
    marks: Vec<Mark>,
    /// Where the last mark stands.
    last_mark: usize,
}

impl<'a> Run<'a> {
    fn new(reading: &'a Reading, control: &'a Control, skip: bool, mark: Option<Mark>, spans: Spans) -> Run<'a> {
        let mut state = State::new(control);
        state.spans = spans;
        if let Some(mark) = mark {
            state.take_over(&mark.carried);
        }
        let index = mark.map_or(0, |mark| mark.block);
        let behind = mark.filter(|_| index > 0).map(|mark| (&reading.blocks[index - 1], mark.carried.ended));
        Run {
            reading,
            state,
            index,
            walk: behind.map_or(Walk::new(skip), |(block, ended)| Walk::behind(block, skip, ended)),
            unreached: Vec::new(),
            ends: Vec::new(),
            held: Vec::new(),
            miscellaneous: Vec::new(),
            marks: Vec::new(),
            last_mark: index,
        }
    }

    /// Executes up to the end, or to the first of these marks, whose blocks have moved by `shift`, that carries what is
    /// carried now; tells which.
    fn until(&mut self, old: &[Mark], shift: usize) -> Option<usize> {
        let mut next = 0;
        while self.index < self.reading.blocks.len() {
            let at = |mark: &Mark| mark.block.wrapping_add(shift);
            while old.get(next).is_some_and(|mark| at(mark) < self.index) {
                next += 1;
            }
            let near = old.get(next).map(at);
            if near == Some(self.index) {
                let (before, now) = (&old[next].carried, self.carried());
                if *before == now && now.pending.is_none() {
                    return Some(next);
                }
            }
            // None right before one that may stand: many edits would leave many of them.
            let apart = near.is_none_or(|near| near == self.index || near - self.index > BETWEEN_MARKS / 2);
            if self.index >= self.last_mark + BETWEEN_MARKS && apart {
                let section = Section::default();
                let mark = Mark { block: self.index, carried: self.carried(), lengths: self.lengths(), section };
                self.marks.push(mark);
                self.last_mark = self.index;
            }
            self.step();
        }
        self.state.finish_span();
        if let Some(last) = self.reading.blocks.len().checked_sub(1) {
            self.ends.push((last, self.walk.ended()));
        }
        None
    }

    /// Executes the next block, or passes it over.
    fn step(&mut self) {
        let index = self.index;
        let block = &self.reading.blocks[index];
        let words = self.reading.words(block);
        let (fate, restarts) = self.walk.meet(block, words);
        if restarts {
            self.state.finish_span();
            self.ends.push((index - 1, true));
            self.state.restart();
        }
        match fate {
            Fate::Executed => {
                run_block(&mut self.state, index, block, words);
                if block.traits.any(Traits::address(b'M')) {
                    self.miscellaneous.push(index);
                }
                self.hold();
            }
            Fate::Skipped => {}
            Fate::Unreached => self.unreached.push(index),
        }
        self.index += 1;
    }

    /// Keeps what the control holds behind the block, where blocks that can be skipped begin or end beside it.
    fn hold(&mut self) {
        let skip = |index: usize| self.reading.blocks.get(index).is_some_and(|block| block.skip);
        let index = self.index;
        if !skip(index) && (skip(index + 1) || index > 0 && skip(index - 1)) {
            self.held.push((index, Held { position: self.state.position, mode: self.state.mode() }));
        }
    }

    fn carried(&self) -> Carried {
        Carried { ended: self.walk.ended(), ..self.state.carried() }
    }

    fn lengths(&self) -> Lengths {
        Lengths {
            spans: self.state.spans.list.len(),
            events: self.state.events.len(),
            unreached: self.unreached.len(),
            ends: self.ends.len(),
            held: self.held.len(),
            miscellaneous: self.miscellaneous.len(),
        }
    }
}
