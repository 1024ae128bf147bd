//! From blocks to spans: modal state, positions, interpolation, feeds (clause 4, annex A).
//!
//! Executing has no messages. What it could not do as written it notes as an [`Event`], which the rules turn into
//! diagnostics, and draws a substitute.

mod arc_block;
pub(crate) mod circle;
mod emit;
mod event;
mod feed;
mod motion;
pub(crate) mod parabola;
mod parabola_block;
mod state;
mod totals;

pub(crate) use circle::ArcFault;
pub(crate) use event::{Event, EventKind, Limit, ParameterReading};
pub use totals::Totals;

use crate::format::Control;
use crate::function::Group;
use crate::read::{Reading, Word};
use crate::span::Spans;
use state::{Mode, State};

/// What executing a tape gave.
#[derive(Clone, Debug, Default)]
pub struct Execution {
    /// The spans, in order.
    pub spans: Spans,
    /// Lengths and times.
    pub totals: Totals,
    /// What could not be done as written.
    pub(crate) events: Vec<Event>,
    /// Blocks that no one executes, because an end of program stands before them.
    pub(crate) unreached: Vec<usize>,
    /// For each program that was executed, its last block and whether it is an end of program.
    pub(crate) ends: Vec<(usize, bool)>,
    /// What the control holds behind each block that was executed; only where the tape has optional block skips.
    pub(crate) held: Vec<(usize, Held)>,
}

/// What a control holds for later blocks.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Held {
    /// Where every axis is, in least input increments.
    pub position: Vec<i64>,
    /// The modal functions and the feed.
    pub mode: Mode,
}

/// Executes what was read. `skip` is the position of the optional block skip switch.
pub(crate) fn execute(reading: &Reading, control: &Control, skip: bool) -> Execution {
    let mut state = State::new(control);
    let mut unreached = Vec::new();
    let mut ends = Vec::new();
    let mut program = None;
    let mut ended = false;
    let mut held = Vec::new();
    let skips = reading.blocks.iter().any(|block| block.skip);
    for (index, block) in reading.blocks.iter().enumerate() {
        // Behind a program without its end, a program start character is a rewind stop and starts no other program.
        if program.replace(block.program) != Some(block.program) && ended {
            state.finish_span();
            ends.push((index - 1, ended));
            state.restart();
            ended = false;
        }
        if ended {
            unreached.push(index);
        } else if !(skip && block.skip) {
            ended = run_block(&mut state, index, reading.words(block));
            if skips {
                held.push((index, Held { position: state.position.clone(), mode: state.mode() }));
            }
        }
    }
    state.finish_span();
    if let Some(last) = reading.blocks.len().checked_sub(1) {
        ends.push((last, ended));
    }
    let State { spans, events, left_out, .. } = state;
    let mut totals = Totals::of(&spans);
    totals.seconds = totals.seconds.filter(|_| !left_out);
    Execution { totals, spans, events, unreached, ends, held }
}

/// Executes one block; tells whether it ends the program.
fn run_block(state: &mut State<'_>, index: usize, words: &[Word]) -> bool {
    let mut ended = false;
    state.begin_block(index);
    for word in words {
        if let Some(code) = word.function(b'G') {
            state.take_preparatory(code);
        }
    }
    for (place, word) in words.iter().enumerate() {
        match word.address {
            b'F' => state.take_feed(place, word),
            b'S' => state.take_speed(place, word),
            b'M' => {
                ended |= matches!(word.value, Some(2 | 30));
                state.take_miscellaneous(place, word);
            }
            _ => state.take_dimension(place, word),
        }
    }
    state.move_tool();
    ended
}

/// Functions that are read and kept, but whose effect on the path is not computed.
pub(crate) fn is_carried_out(group: Group, code: u8) -> bool {
    match group {
        Group::Motion => !matches!(code, 33..=35),
        Group::Plane | Group::Dimensions | Group::Positioning | Group::Feed => true,
        Group::Spindle => code == 97,
        Group::Compensation => code == 40,
        Group::Shift => code == 53,
        Group::Cycle => code == 80,
        Group::Offset => false,
        Group::Once => matches!(code, 8 | 9),
    }
}
