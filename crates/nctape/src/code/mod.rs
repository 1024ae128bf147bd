//! The two character codes of the tape, and the way from a listing to rows of holes.
//!
//! A row is one byte: track n is bit n-1. [`iso840`] has even parity on track 8, [`rs244`] odd parity on track 5,
//! so that no row means something in both.

mod decode;
mod encode;
mod explain;
mod file;
pub mod iso840;
mod label;
pub mod lettering;
mod recognise;
pub mod rs244;

pub use decode::{DecodeOptions, Decoded, RowIssue, RowIssueKind, decode};
pub(crate) use encode::encode_from;
pub use encode::{Rows, encode};
pub use explain::{RowWords, about_tape};
pub use file::{Opened, open};
use recognise::{Track8, recognise, track_8};

/// A character code of punched tape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Code {
    /// ISO 840, the subset that EIA RS-358 names for machine control: seven bits and even parity on track 8.
    Iso,
    /// EIA RS-244: tracks 1 to 4 binary-coded decimal, 5 odd parity, 6 and 7 zone, 8 end of block.
    Eia,
}

/// Which row ends a block in ISO code.
///
/// ISO 2539 B.2 names LF. Y-1702 gives tracks 1, 3, 4 and 8 in its text, which is CR, and LF in its figure 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum EndOfBlock {
    /// LF, tracks 2 and 4.
    #[default]
    Lf,
    /// CR, tracks 1, 3, 4 and 8.
    Cr,
}

impl Code {
    /// The row of a character as it stands in a listing; `None` if the code lacks it.
    ///
    /// Both codes know one case of letters: lower case is punched like upper case. The end of block is no
    /// character of a listing; see [`Code::end_of_block`].
    pub fn row(self, character: char) -> Option<u8> {
        let ascii = u8::try_from(u32::from(character)).ok().filter(u8::is_ascii)?.to_ascii_uppercase();
        match self {
            Code::Iso => iso840::row(ascii),
            Code::Eia => rs244::row(ascii),
        }
    }

    /// The character that a row stands for in a listing; `None` for the end of block, for a row without one, and for
    /// a typewriter's shift.
    pub fn character(self, row: u8) -> Option<char> {
        let ascii = match self {
            Code::Iso => iso840::ascii(row),
            Code::Eia => rs244::ascii(row),
        };
        ascii.filter(|&ascii| ascii != b'\n').map(char::from)
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Code::Iso => "ISO 840",
            Code::Eia => "EIA RS-244",
        }
    }

    /// The row that ends a block.
    pub fn end_of_block(self, iso: EndOfBlock) -> u8 {
        match (self, iso) {
            (Code::Eia, _) => rs244::END_OF_BLOCK,
            (Code::Iso, EndOfBlock::Lf) => 0x0A,
            (Code::Iso, EndOfBlock::Cr) => 0x8D,
        }
    }

    /// Whether a row has the parity of the code: even in ISO, odd in EIA.
    pub fn parity_fits(self, row: u8) -> bool {
        row.count_ones() % 2 == u32::from(self == Code::Eia)
    }

    /// What a row stands for: a short label to set beside it and its name. `None` for a row without meaning.
    pub fn meaning(self, row: u8) -> Option<(String, &'static str)> {
        match self {
            Code::Iso => iso840::meaning(row),
            Code::Eia => rs244::meaning(row),
        }
    }
}
