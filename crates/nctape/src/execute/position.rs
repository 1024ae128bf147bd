//! Where every axis is.

use std::ops::{Deref, DerefMut};

/// The most axes that a format can have: the dimension letters without I, J and K.
const MOST_AXES: usize = 14;

/// Where every axis is, in least input increments; as many as the control has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Position {
    at: [i64; MOST_AXES],
    axes: u8,
}

impl Position {
    pub(crate) fn new(increments: &[i64]) -> Position {
        let mut at = [0; MOST_AXES];
        let axes = increments.len().min(MOST_AXES);
        at[..axes].copy_from_slice(&increments[..axes]);
        Position { at, axes: axes as u8 }
    }
}

impl Deref for Position {
    type Target = [i64];

    fn deref(&self) -> &[i64] {
        &self.at[..usize::from(self.axes)]
    }
}

impl DerefMut for Position {
    fn deref_mut(&mut self) -> &mut [i64] {
        &mut self.at[..usize::from(self.axes)]
    }
}
