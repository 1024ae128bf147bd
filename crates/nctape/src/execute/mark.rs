//! Places from which executing can go on.

use super::compensation::Compensation;
use super::feed::Feed;
use super::position::Position;
use super::section::Section;
use super::state::{Motion, Pending};
use crate::format::{FeedCoding, FeedUnit, Plane};

/// What passes from one block to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Carried {
    pub motion: Option<Motion>,
    pub plane: Plane,
    pub incremental: bool,
    pub feed: Feed,
    pub speed: Option<f64>,
    pub cutting_speed: bool,
    pub any_speed: bool,
    pub coding: FeedCoding,
    pub unit: FeedUnit,
    pub compensation: Compensation,
    pub position: Position,
    pub pending: Option<Pending>,
    pub leads: [i64; 3],
    pub lost: u32,
    pub lost_function: bool,
    /// There was a span before.
    pub moved: bool,
    /// The program has ended.
    pub ended: bool,
}

/// What the control carries into a block, and how long the tables of execution were before it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    pub block: usize,
    pub carried: Carried,
    pub lengths: Lengths,
    /// The spans from the mark before it to this one.
    pub section: Section,
}

/// How long the tables of execution are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lengths {
    pub spans: usize,
    pub events: usize,
    pub unreached: usize,
    pub ends: usize,
    pub held: usize,
    pub miscellaneous: usize,
}
