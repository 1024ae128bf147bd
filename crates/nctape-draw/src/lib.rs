//! Draws eight-track punched tape true to scale.
//!
//! A row of tape is a byte: track *n* is bit *n* - 1, counted from the lowest, and a set bit is a hole.
//! On the way from there to a picture come, in this order:
//!
//! 1. [`dimensions`]: what the standards say of the tape, in millimetres, with tolerance and source.
//! 2. [`Theme`]: the colours of the bench and of the paper on it.
//! 3. [`Columns`]: the 256 rows that there are, drawn once for a pitch and a theme.
//! 4. [`tile`](tile()): a stretch of tape, copied together from columns.
//! 5. [`Picture`]: the pixels, as a browser's canvas takes them.
//!
//! [`svg`] draws the same tape in millimetres, for paper.
//!
//! ```
//! use nctape_draw::{Columns, Theme, tile};
//!
//! // Sixteen pixels from row to row.
//! let columns = Columns::new(16, Theme::Light);
//! // The rows of "N1" in ISO 840, the parity in track 8, between two without code holes.
//! let picture = tile(&[0x00, 0x4e, 0xb1, 0x00], &columns);
//!
//! assert_eq!(picture.width, 4 * 16);
//! // The tape is one inch wide and has ten rows to the inch.
//! assert_eq!(columns.paper_height(), 10 * 16);
//! assert_eq!(picture.rgba.len() as u32, picture.width * picture.height * 4);
//! ```
//!
//! # Which way up
//!
//! Rows run from left to right in the order of reading, with track 8 on top and the reference edge,
//! the one beside tracks 1 to 3, at the bottom.
//! A row then reads downwards as its byte is written, highest bit first,
//! and the edge from which everything is measured is the base line.
//! It is the face that a chart with track 8 on the left shows when its rows run upwards;
//! a chart whose rows run downwards shows the other face.
//!
//! # Invariants
//!
//! - Every pixel is opaque.
//! - The same rows at the same pitch and in the same theme always give the same bytes.
//! - Any two columns fit together without a seam.
//! - A blank row is not empty: it has its feed hole.
//!
//! # Out of scope
//!
//! - Text. The page sets the characters under the rows and the block numbers above them.
//! - Marks: a row of wrong parity, the row under the cursor and the reader's head are drawn by the page, over the tape.
//! - Codes. What a row means is for the crate `nctape` to say; here it is holes.
//! - Files of pixels. A browser encodes its canvas itself, and encoding takes longer than drawing.
//! - Tape of five, six or seven tracks.

pub mod dimensions;

mod columns;
mod hole;
mod layout;
mod paper;
mod picture;
mod theme;
mod tile;
mod vector;

pub use crate::columns::Columns;
pub use crate::picture::Picture;
pub use crate::theme::{Colours, Rgb, Theme};
pub use crate::tile::tile;
pub use crate::vector::svg;
