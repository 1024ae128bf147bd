//! COMP: cutter compensation.

pub(crate) mod centre_in_vector;
pub(crate) mod cutter_too_large;
pub(crate) mod unit_vector;
pub(crate) mod vector_as_axes;
pub(crate) mod vector_aside;

use super::TapeView;
use std::ops::Range;

/// From the first to the last of P, Q and R of a block; the whole block where it has none.
fn vector_words(tape: &TapeView<'_>, index: usize) -> Range<usize> {
    let block = &tape.reading.blocks[index];
    let mut words = tape.reading.words(block).iter().filter(|word| matches!(word.address, b'P' | b'Q' | b'R'));
    let Some(first) = words.next() else { return tape.extent(index) };
    let last = words.next_back().unwrap_or(first);
    tape.range(block, first).start..tape.range(block, last).end
}
