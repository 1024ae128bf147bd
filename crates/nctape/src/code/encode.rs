//! From a listing to rows of holes.

use super::{Code, EndOfBlock};
use crate::text::{Listing, Mark, TapeCharacter};

/// The rows of a tape, and the character of the listing that each stands for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rows {
    /// One byte a row: track n is bit n-1.
    pub bytes: Vec<u8>,
    /// For each row the first byte of its character in the listing.
    pub offsets: Vec<u32>,
}

/// Punches a listing.
///
/// Comments are punched, layout is left out, and so is a character that the code lacks: the check reports it.
/// There is no leader and no trailer.
///
/// ```
/// use nctape::code::{Code, EndOfBlock, encode};
/// let rows = encode("N025 G01*", Code::Eia, EndOfBlock::Lf);
/// assert_eq!(rows.bytes, [0x45, 0x20, 0x02, 0x15, 0x67, 0x20, 0x01, 0x80]);
/// ```
pub fn encode(listing: &str, code: Code, end_of_block: EndOfBlock) -> Rows {
    encode_from(listing, 0, code, end_of_block, 0, usize::MAX)
}

/// The same from a byte on that is in no comment: at most `count` rows, behind the first `skip`.
pub(crate) fn encode_from(
    listing: &str,
    at: usize,
    code: Code,
    end_of_block: EndOfBlock,
    skip: usize,
    count: usize,
) -> Rows {
    let punched = Listing::resume(listing, at, false).filter_map(|character| {
        let row = match character.mark {
            Mark::EndOfBlock => Some(code.end_of_block(end_of_block)),
            Mark::Character(c) => code.row(c),
        };
        row.map(|row| (row, character.from as u32))
    });
    let (bytes, offsets) = punched.skip(skip).take(count).unzip();
    Rows { bytes, offsets }
}

impl TapeCharacter {
    /// It is punched: the code has a row for it.
    pub(crate) fn has_row(&self, code: Code) -> bool {
        match self.mark {
            Mark::EndOfBlock => true,
            Mark::Character(c) => code.row(c).is_some(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hex(bytes: &[u8]) -> String {
        bytes.iter().map(|b| format!("{b:02X}")).collect::<Vec<_>>().join(" ")
    }

    // The two vectors were made by script from code tables transcribed independently of this crate.

    #[test]
    fn the_block_of_y_1702() {
        let block = "n025g01x-03216y+00782f415m01\n";
        assert_eq!(
            hex(&encode(block, Code::Eia, EndOfBlock::Lf).bytes),
            "45 20 02 15 67 20 01 37 40 20 13 02 01 16 38 70 20 20 07 08 02 76 04 01 15 54 20 01 80"
        );
        assert_eq!(
            hex(&encode(block, Code::Iso, EndOfBlock::Lf).bytes),
            "4E 30 B2 35 47 30 B1 D8 2D 30 33 B2 B1 36 59 2B 30 30 B7 B8 B2 C6 B4 B1 35 4D 30 B1 0A"
        );
    }

    #[test]
    fn the_first_block_of_iso_2539_annex_e() {
        let tape = "%\nN001G01X010000Y010000Z020000F0300M05\n";
        assert_eq!(
            hex(&encode(tape, Code::Eia, EndOfBlock::Lf).bytes),
            "0B 80 45 20 20 01 67 20 01 37 20 01 20 20 20 20 38 20 01 20 20 20 20 29 20 02 20 20 20 20 76 20 13 20 20 \
             54 20 15 80"
        );
        assert_eq!(
            hex(&encode(tape, Code::Iso, EndOfBlock::Lf).bytes),
            "A5 0A 4E 30 30 B1 47 30 B1 D8 30 B1 30 30 30 30 59 30 B1 30 30 30 30 5A 30 B2 30 30 30 30 C6 30 33 30 30 \
             4D 30 35 0A"
        );
    }

    #[test]
    fn layout_has_no_hole_but_a_comment_is_punched_whole() {
        let rows = encode("N1 (A B)\r\n", Code::Iso, EndOfBlock::Cr);
        assert_eq!(hex(&rows.bytes), "4E B1 28 41 A0 42 A9 8D");
        assert_eq!(rows.offsets, [0, 1, 3, 4, 5, 6, 7, 8]);
    }

    #[test]
    fn a_character_that_the_code_lacks_is_left_out() {
        assert_eq!(encode("X#1.\u{2212}:", Code::Iso, EndOfBlock::Lf).bytes, [0xD8, 0xB1, 0x3A]);
        assert_eq!(encode("X#1.\u{2212}:", Code::Eia, EndOfBlock::Lf).bytes, [0x37, 0x01, 0x6B]);
    }
}
