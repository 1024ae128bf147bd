//! Letters for people: a name punched into the leader, to be read by eye.
//!
//! The letters stand on tracks 1 to 7 and leave track 8 alone. Track 8 by itself is the end of block of EIA code, and
//! with others the carriage return and `%` of ISO code; what is left to avoid, tracks 2 and 4 (the line feed of ISO
//! code) and 1, 2 and 4 (the stop code of EIA code), no column of the table has. So a name ends no block and starts no
//! program, whatever the code, and a control that waits for the first end of block passes over it.

use crate::text::{Listing, Mark};

/// Blank rows before and behind the letters: an inch, so that they stand apart from the program.
pub const MARGIN: usize = 10;

/// Blank rows between two letters, and for a blank between two words.
const BETWEEN: usize = 1;
const BLANK: usize = 3;

/// Seven lines from track 7 down to track 1. The feed holes run between the fourth line and the fifth.
type Glyph = [&'static str; 7];

#[rustfmt::skip]
const GLYPHS: [(char, Glyph); 46] = [
    ('!', ["#", "#", "#", "#", "#", " ", "#"]),
    ('&', [" ##  ", "#  # ", "# #  ", " #   ", "# # #", "#  # ", " ## #"]),
    ('\'', ["#", "#", "#", " ", " ", " ", " "]),
    ('+', ["     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "]),
    (',', ["  ", "  ", "  ", "  ", "  ", " #", "# "]),
    ('-', ["   ", "   ", "   ", "###", "   ", "   ", "   "]),
    ('.', [" ", " ", " ", " ", " ", " ", "#"]),
    ('/', ["    #", "    #", "   # ", "  #  ", " #   ", "#    ", "#    "]),
    ('0', [" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "]),
    ('1', [" # ", "## ", " # ", " # ", " # ", " # ", "###"]),
    ('2', [" ### ", "#   #", "    #", "  ## ", " #   ", "#    ", "#####"]),
    ('3', ["#### ", "    #", "    #", " ### ", "    #", "    #", "#### "]),
    ('4', ["   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "]),
    ('5', ["#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "]),
    ('6', ["  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "]),
    ('7', ["#####", "    #", "   # ", "  #  ", " #   ", " #   ", " #   "]),
    ('8', [" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "]),
    ('9', [" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "]),
    (':', [" ", " ", "#", " ", " ", "#", " "]),
    ('?', [" ### ", "#   #", "    #", "  ## ", "  #  ", "     ", "  #  "]),
    ('A', [" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"]),
    ('B', ["#### ", "#   #", "#   #", "#### ", "#   #", "#   #", "#### "]),
    ('C', [" ### ", "#   #", "#    ", "#    ", "#    ", "#   #", " ### "]),
    ('D', ["#### ", "#   #", "#   #", "#   #", "#   #", "#   #", "#### "]),
    ('E', ["#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"]),
    ('F', ["#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#    "]),
    ('G', [" ### ", "#   #", "#    ", "# ###", "#   #", "#   #", " ### "]),
    ('H', ["#   #", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"]),
    ('I', ["###", " # ", " # ", " # ", " # ", " # ", "###"]),
    ('J', ["  ###", "   # ", "   # ", "   # ", "   # ", "#  # ", " ##  "]),
    ('K', ["#   #", "#  # ", "# #  ", "##   ", "# #  ", "#  # ", "#   #"]),
    ('L', ["#    ", "#    ", "#    ", "#    ", "#    ", "#    ", "#####"]),
    ('M', ["#   #", "## ##", "# # #", "# # #", "#   #", "#   #", "#   #"]),
    ('N', ["#   #", "#   #", "##  #", "# # #", "#  ##", "#   #", "#   #"]),
    ('O', [" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "]),
    ('P', ["#### ", "#   #", "#   #", "#### ", "#    ", "#    ", "#    "]),
    ('Q', [" ### ", "#   #", "#   #", "#   #", "# # #", "#  # ", " ## #"]),
    ('R', ["#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"]),
    ('S', [" ####", "#    ", "#    ", " ### ", "    #", "    #", "#### "]),
    ('T', ["#####", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  "]),
    ('U', ["#   #", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "]),
    ('V', ["#   #", "#   #", "#   #", "#   #", "#   #", " # # ", "  #  "]),
    ('W', ["#   #", "#   #", "#   #", "# # #", "# # #", "## ##", "#   #"]),
    ('X', ["#   #", "#   #", " # # ", "  #  ", " # # ", "#   #", "#   #"]),
    ('Y', ["#   #", "#   #", " # # ", "  #  ", "  #  ", "  #  ", "  #  "]),
    ('Z', ["#####", "    #", "   # ", "  #  ", " #   ", "#    ", "#####"]),
];

/// The rows of a text in letters for people, with [`MARGIN`] before and behind them; none where the text has no
/// character that can be lettered. Lower case is lettered in capitals.
///
/// ```
/// use nctape::code::lettering::{MARGIN, lettering};
/// let rows = lettering("L");
/// // A stroke through all seven tracks, then its foot on track 1.
/// assert_eq!(rows[MARGIN..rows.len() - MARGIN], [0b111_1111, 1, 1, 1, 1]);
/// assert!(lettering(" ").is_empty());
/// ```
pub fn lettering(text: &str) -> Vec<u8> {
    let mut letters: Vec<u8> = Vec::new();
    let mut blanks = 0;
    for character in text.chars().flat_map(char::to_uppercase) {
        if character.is_whitespace() {
            blanks = BLANK;
            continue;
        }
        let Some(glyph) = glyph(character) else { continue };
        if !letters.is_empty() {
            letters.extend(std::iter::repeat_n(0, BETWEEN + blanks));
        }
        blanks = 0;
        letters.extend(columns(glyph));
    }
    if letters.is_empty() {
        return letters;
    }
    let margin = [0; MARGIN];
    [&margin[..], &letters, &margin].concat()
}

/// What a control makes of the letters before this listing, in words.
///
/// What stands before the first end of block belongs to no block (ISO 2539 3.2.1.3, which demands that end of block;
/// ISO 1058 3.2.1.3 allows it).
pub fn advice(listing: &str) -> &'static str {
    if begins_with_end_of_block(listing) {
        "Letters for people. A control passes over them: it reads from the first end of block on (ISO 2539 3.2.1.3)."
    } else {
        "This tape has no end of block before its first block: a control would pass over that block with the letters, \
         or read the letters as characters. Put an end of block first (ISO 2539 3.2.1.3)."
    }
}

/// An end of block stands before the first block; `%` with its number and comments may stand before it.
fn begins_with_end_of_block(listing: &str) -> bool {
    let program = Listing::new(listing)
        .filter(|character| !character.comment && !matches!(character.mark, Mark::Character('(' | ')')));
    let mut head = program.skip_while(|character| match character.mark {
        Mark::Character(character) => character == '%' || character.is_ascii_digit(),
        Mark::EndOfBlock => false,
    });
    head.next().is_some_and(|character| character.mark == Mark::EndOfBlock)
}

/// The characters of a text that cannot be lettered, each once.
pub fn missing(text: &str) -> String {
    let mut missing = String::new();
    for character in text.chars() {
        let lettered = character.is_whitespace() || character.to_uppercase().any(|capital| glyph(capital).is_some());
        if !lettered && !missing.contains(character) {
            missing.push(character);
        }
    }
    missing
}

fn glyph(capital: char) -> Option<&'static Glyph> {
    GLYPHS.iter().find(|(character, _)| *character == capital).map(|(_, glyph)| glyph)
}

/// The rows of a glyph from left to right.
fn columns(glyph: &'static Glyph) -> impl Iterator<Item = u8> {
    (0..glyph[0].len())
        .map(|column| glyph.iter().fold(0, |row, line| row << 1 | u8::from(line.as_bytes()[column] == b'#')))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::code::{Code, EndOfBlock};

    #[test]
    fn no_column_ends_a_block_or_starts_a_program_in_either_code() {
        let ends = [
            Code::Iso.end_of_block(EndOfBlock::Lf),
            Code::Iso.end_of_block(EndOfBlock::Cr),
            Code::Eia.end_of_block(EndOfBlock::Lf),
        ];
        // A comment that opens in the leader would swallow the program on a control that looks for it there.
        let starts = [Code::Iso, Code::Eia].iter().flat_map(|code| [code.row('%'), code.row('(')]).flatten();
        let forbidden: Vec<u8> = ends.into_iter().chain(starts).collect();
        assert_eq!(forbidden, [0x0A, 0x8D, 0x80, 0xA5, 0x28, 0x0B, 0x1A]);
        for (character, glyph) in &GLYPHS {
            for row in columns(glyph) {
                assert!(!forbidden.contains(&row), "{character}: {row:02X}");
                assert!(row < 0x80, "{character} reaches track 8");
            }
        }
    }

    #[test]
    fn every_glyph_is_a_block_of_lines_with_a_hole_in_its_outer_columns() {
        for (character, glyph) in &GLYPHS {
            assert!(glyph.iter().all(|line| line.len() == glyph[0].len()), "{character}");
            let rows: Vec<u8> = columns(glyph).collect();
            assert!(rows[0] != 0 && rows[rows.len() - 1] != 0, "{character} would stand off its neighbours");
        }
        let mut characters: Vec<char> = GLYPHS.iter().map(|(character, _)| *character).collect();
        characters.dedup();
        assert_eq!(characters.len(), GLYPHS.len());
        assert!(('A'..='Z').chain('0'..='9').all(|character| glyph(character).is_some()));
    }

    #[test]
    fn letters_stand_apart_and_words_further() {
        let inner = |text: &str| {
            let rows = lettering(text);
            rows[MARGIN..rows.len() - MARGIN].to_vec()
        };
        assert_eq!(inner("i!"), [0x41, 0x7F, 0x41, 0x00, 0x7D]);
        assert_eq!(inner("! !"), [0x7D, 0, 0, 0, 0, 0x7D]);
        assert_eq!(inner("  !  "), [0x7D], "blanks at the ends are left out");
    }

    #[test]
    fn the_advice_depends_on_what_stands_before_the_first_block() {
        for good in ["%\nN001G01\n", "\nN001\n", "*N001*", "%12\nN001\n", "(PART)%\nN001\n"] {
            assert!(advice(good).contains("passes over them"), "{good}");
        }
        for bad in ["N001G01\n", "%N001\n", "(\n)N001\n", ""] {
            assert!(advice(bad).contains("Put an end of block first"), "{bad}");
        }
    }

    #[test]
    fn what_cannot_be_lettered_is_named() {
        assert_eq!(missing("J\u{f6}rg \u{4e16}\u{754c}\u{4e16} 1!"), "\u{f6}\u{4e16}\u{754c}");
        assert_eq!(missing("stra\u{df}e"), "", "\u{df} is SS in capitals");
        assert!(lettering("\u{4e16}").is_empty());
    }
}
