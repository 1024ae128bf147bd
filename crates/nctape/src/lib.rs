//! Numerical-control punched tape: ISO 2539, ISO 1058 and EIA RS-274.
//!
//! The way of the data, which is also the order of the modules:
//!
//! ```text
//! text ─► words ─► blocks ─► spans ─► points
//!  │        └────────┴────────┴─► diagnostics
//!  └─► rows of holes
//! ```
//!
//! A [`Format`] says what control the tape is for; a [`Tape`] holds a text under a format and all that follows from
//! it. Reading never fails: any text gives blocks and diagnostics.
//!
//! ```
//! use nctape::{Format, Standard, Tape};
//!
//! let format = Format::new(Standard::Iso2539, "N3G2X+42Y+32F4M2*").classified("CAM 222");
//! let tape = Tape::new("%\nN001 G01 X+1000 F0300\nN002 M30\n", &format);
//! let first = &tape.diagnostics()[0];
//! assert_eq!(first.id, "NUM-01");
//! assert_eq!(first.message, "X has 4 digits; this format wants 6 (X+42).");
//! assert_eq!(&tape.text()[first.range.clone()], "X+1000");
//! ```
//!
//! The other language is CLDATA, which a tape is made from: [`cldata`].
//!
//! Offsets are bytes of the text. Lengths are exact integers, in least input increments, up to interpolation; from
//! there they are `f64` in the unit of the format. A span ends on its programmed end point to the bit.

pub mod text;

pub mod format;

pub mod code;

pub mod read;

pub mod function;

pub mod speed;

pub mod cldata;

mod execute;

pub mod span;

pub mod flatten;

pub mod diagnostic;

pub mod rules;

mod report;

mod order;

mod tape;

mod write;

pub mod convert;

pub mod post;

mod suggest;

pub mod offset;

pub mod presets;

mod same;

pub use diagnostic::{Diagnostic, Language, Severity};
pub use execute::{
    BlockTimes, Bounds, Course, Dwelling, Fate, Kept, Modal, Named, Rate, Registers, Step, Stop, TapeTime, Totals,
    Turning, ZeroRows,
};
pub use format::{Format, Standard};
pub use same::same_path;
pub use suggest::{Suggestion, suggest};
pub use tape::{ROW_PITCH_MILLIMETRES, Tape};

/// The README, so that its Rust lines are compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
