//! From blocks to spans: modal state, positions, interpolation, feeds (clause 4, annex A).
//!
//! Executing has no messages. What it could not do as written it notes as an [`Event`], which the rules turn into
//! diagnostics, and draws a substitute.

mod arc_block;
pub(crate) mod circle;
mod compensation;
mod course;
pub(crate) mod cubic;
mod curve_block;
mod dwell;
mod emit;
mod event;
mod execution;
mod feed;
mod follow;
mod mark;
mod motion;
pub(crate) mod parabola;
mod parabola_block;
mod position;
mod registers;
mod section;
mod state;
mod thread;
mod timetable;
mod totals;
mod walk;

pub(crate) use circle::{ArcFault, Lack};
pub use course::{Course, Step, Stop};
pub(crate) use event::{Event, EventKind, Several};
pub(crate) use execution::execute;
pub use execution::{Execution, Kept};
pub(crate) use follow::{FeedInForce, Follow, Step as Followed};
pub(crate) use parabola::ParabolaFault;
pub use registers::{Dwelling, Modal, Named, Rate, Registers, Turning};
pub(crate) use timetable::cut_and_read;
pub use timetable::{BlockTimes, TapeTime, ZeroRows};
pub(crate) use totals::Share;
pub use totals::{Bounds, Totals};
pub use walk::Fate;
pub(crate) use walk::ends_program;

use crate::function::Group;
use crate::read::{Block, Traits, Word};
use position::Position;
pub(crate) use state::in_unit;
use state::{Mode, State};

/// What a control holds for later blocks.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Held {
    /// Where every axis is, in least input increments.
    pub position: Position,
    /// The modal functions and the feed.
    pub mode: Mode,
}

/// Executes one block.
fn run_block(state: &mut State<'_>, index: usize, block: &Block, words: &[Word]) {
    state.begin_block(index);
    // Digits without an address may be those of any word.
    if block.traits.any(Traits::address(b'G').with(Traits::address(0))) {
        for word in words {
            match word.function(b'G') {
                Some(code) => state.take_preparatory(code),
                None => state.lost_function |= matches!(word.address, b'G' | 0),
            }
        }
    }
    for (place, word) in words.iter().enumerate() {
        match word.address {
            _ if state.is_dwell(word) => state.take_dwell(place, word),
            b'F' => state.take_feed(place, word),
            b'S' => state.take_speed(place, word),
            b'M' => state.take_miscellaneous(place, word),
            _ => state.take_dimension(place, word),
        }
    }
    state.move_tool();
}

/// Functions that are read and kept, but whose effect on the path is not computed.
pub(crate) fn is_carried_out(group: Group, code: u8) -> bool {
    match group {
        Group::Motion => !matches!(code, 34 | 35),
        Group::Plane | Group::Dimensions | Group::Positioning | Group::Feed => true,
        Group::Spindle => code == 97,
        // Without the radius of the cutter there is nothing to draw: see `State::take_preparatory`.
        Group::Compensation => true,
        Group::Shift => code == 53,
        Group::Cycle => code == 80,
        Group::Offset => false,
        Group::Once => matches!(code, 8 | 9),
    }
}
