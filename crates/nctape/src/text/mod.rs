//! The listing: what a person pastes, seen as the characters of a tape.
//!
//! A listing has line ends, blanks for the eye and, often, `*` for the end of block.
//! [`Listing`] is the one place that says which character of the tape each of them stands for; reading and
//! punching both go through it, so that they cannot disagree.

mod listing;

pub use listing::{Listing, Mark, TapeCharacter};
