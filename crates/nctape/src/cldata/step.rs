//! What a text says one after the other, for the post-processor: the same carrying out that gives the spans, kept step
//! by step with all that a tape needs and a drawing does not.

use super::command::Argument;
use super::execution::{Per, State};
use super::words::Key;
use crate::span::Arc;

/// One thing that a record says.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    /// Its record.
    pub record: usize,
    /// One unit of its file in units of [`super::Cldata::unit`].
    pub scale: f64,
    pub act: Act,
}

/// What it is.
#[derive(Clone, Debug)]
pub(crate) enum Act {
    /// FROM: the tool stands here.
    From([f64; 3]),
    /// A move, boxed: most steps are smaller.
    Motion(Box<Motion>),
    /// A command of the post-processor, and what stands behind its word.
    Command { word: Key, arguments: Vec<Argument> },
    /// The tool axis of all points without one of their own (9000,10).
    ToolAxis([f64; 3]),
    /// A record or a command that cannot be read, or whose meaning is not public, and that may bear on the tape.
    Unread,
}

/// A move to a point. Lengths are in the unit of the report, angles in radians.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    /// Along a circle, or straight.
    pub arc: Option<Arc>,
    /// Where it begins, if that is known.
    pub from: Option<[f64; 3]>,
    pub to: [f64; 3],
    /// The tool axis at its end, as the file says it.
    pub axis: Option<[f64; 3]>,
    /// It stands behind RAPID.
    pub rapid: bool,
    /// All of its coordinates were read, and it is no stand-in for an arc.
    pub sound: bool,
    /// Its first coordinate in the table of all elements.
    pub element: usize,
    /// The record of the circle that it runs along.
    pub circle: Option<usize>,
    /// The feed in the unit of the report per minute or per revolution.
    pub feed: Option<f64>,
    pub per: Per,
    /// The spindle speed in revolutions per minute, as far as one was said.
    pub speed: Option<f64>,
}

impl State<'_> {
    /// Keeps a step, where steps are wanted.
    pub(super) fn keep(&mut self, record: usize, act: impl FnOnce(&State<'_>) -> Act) {
        if self.keeps {
            let act = act(self);
            self.steps.push(Step { record, scale: self.file.scale, act });
        }
    }
}
