//! Following a tape block by block: what the control has in hand behind each.

use super::feed::{Feed, read_speed};
use super::position::Position;
use super::run_block;
use super::state::{Motion, State};
use super::walk::{Fate, Walk};
use crate::Tape;
use crate::format::Standard;
use crate::read::{Block, Word};
use crate::span::Span;
use std::ops::Range;

/// Goes through a tape once more, for who turns it into something else: the spans are the tape's own.
pub(crate) struct Follow<'a> {
    tape: &'a Tape,
    state: State<'a>,
    walk: Walk,
    next: usize,
    /// Where the last block started.
    before: Position,
    /// Spans up to here belong to blocks before the next one.
    span: usize,
}

/// A block that was met.
pub(crate) struct Step<'a> {
    pub index: usize,
    pub block: &'a Block,
    pub words: &'a [Word],
    pub fate: Fate,
    /// The spans that are carried out with it: those of which it is the last block.
    pub spans: Range<usize>,
}

/// How a tape states the feed in force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum FeedInForce {
    /// Not at all, or by a word that says no number.
    Unknown,
    /// Unit per minute.
    PerMinute(f64),
    /// Unit per revolution of the spindle.
    PerRevolution(f64),
    /// As the reciprocal of time: so many times a minute.
    Reciprocal(f64),
    /// As fast as the machine moves.
    Rapid,
}

impl<'a> Follow<'a> {
    pub(crate) fn new(tape: &'a Tape) -> Follow<'a> {
        Follow {
            tape,
            state: State::new(tape.control()),
            walk: Walk::new(tape.skip()),
            next: 0,
            before: Position::new(&tape.control().set_point),
            span: 0,
        }
    }

    /// Executes the next block, or passes it over.
    pub(crate) fn step(&mut self) -> Option<Step<'a>> {
        let tape = self.tape;
        let reading = tape.reading();
        let (index, block) = (self.next, reading.blocks.get(self.next)?);
        self.next += 1;
        let words = reading.words(block);
        let (fate, restarts) = self.walk.meet(block, words);
        if restarts {
            self.state.finish_span();
            self.state.restart();
        }
        self.before = self.state.position;
        if fate == Fate::Executed {
            run_block(&mut self.state, index, block, words);
        }
        // The tape has them already.
        self.state.spans = tape.spans().empty(0);
        self.state.events.clear();
        let all: &[Span] = &tape.spans().list;
        let first = self.span;
        self.span += all[first..].iter().take_while(|span| span.blocks.1 <= index).count();
        Some(Step { index, block, words, fate, spans: first..self.span })
    }

    /// The block met last has a dimension word of an axis that can be used.
    pub(crate) fn addressed(&self, axis: usize) -> bool {
        self.state.words[axis].is_some()
    }

    /// Where the last block takes an axis, in the unit of the format.
    pub(crate) fn target(&self, axis: usize) -> f64 {
        self.state.in_unit(axis, self.state.target[axis])
    }

    /// The last block is a point of a span that is not complete yet.
    pub(crate) fn waits(&self) -> bool {
        self.state.pending.is_some()
    }

    /// The feed behind the last block.
    pub(crate) fn feed(&self) -> FeedInForce {
        match self.state.feed {
            Feed::PerMinute(feed) if feed > 0.0 => FeedInForce::PerMinute(feed),
            Feed::PerRevolution(feed) if feed > 0.0 => FeedInForce::PerRevolution(feed),
            Feed::Reciprocal(rate) if rate > 0.0 => FeedInForce::Reciprocal(rate),
            Feed::Rapid => FeedInForce::Rapid,
            _ => FeedInForce::Unknown,
        }
    }

    /// How long the last block dwells, in seconds.
    pub(crate) fn dwell(&self) -> Option<f64> {
        self.state.pause.and_then(|pause| pause.seconds)
    }

    /// What the word of a dwell counts, in the unit of the dwell.
    pub(crate) fn counted(&self) -> Option<f64> {
        self.state.pause.and_then(|pause| pause.counted)
    }

    /// Revolutions per minute of the spindle, where they are known.
    pub(crate) fn speed(&self) -> Option<f64> {
        self.state.speed.filter(|speed| *speed > 0.0)
    }

    /// The interpolation in force is positioning.
    pub(crate) fn is_rapid(&self) -> bool {
        let positions = self.tape.standard() == Standard::Iso1058;
        self.state.motion.map_or(positions, |motion| motion == Motion::Rapid)
    }

    /// How the dimension words of an axis are read.
    pub(crate) fn is_incremental(&self, axis: usize) -> bool {
        self.state.is_incremental(axis)
    }

    /// The leads along X, Y and Z of a thread, in the unit of the format.
    pub(crate) fn leads(&self) -> [f64; 3] {
        self.state.leads_in_force().unwrap_or([0.0; 3])
    }

    /// The last block is a thread.
    pub(crate) fn is_thread(&self) -> bool {
        self.state.is_thread()
    }

    /// The lead along its path of a thread that the last block cuts.
    pub(crate) fn lead(&self, length: f64) -> Option<f64> {
        self.state.thread_turns(&self.before, length).map(|turns| length / turns)
    }

    /// What an S word says by the coding of the format, revolutions or cutting speed.
    pub(crate) fn spindle_number(&self, word: &Word) -> Option<f64> {
        read_speed(word, self.tape.control()).0.filter(|speed| speed.is_finite())
    }
}
