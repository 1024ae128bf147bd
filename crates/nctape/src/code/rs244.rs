//! EIA RS-244: binary-coded decimal on tracks 1 to 4, odd parity on track 5, zone on tracks 6 and 7, end of block
//! alone on track 8.
//!
//! Digits and letters are agreed on by every source; RS-244 itself was not at hand. They were compared between the
//! Friden "President" table of Hack42's Punchconverter, the IBM 8-channel tape of SIMH's 1620 and the EIA column of
//! the Bastelbude encoding page. What rests on fewer sources says so.

/// The end-of-block row: track 8 alone, the only use of that track.
pub const END_OF_BLOCK: u8 = 0x80;

/// Every character that has a row, but the end of block: ASCII stand-in in a listing, row, name.
///
/// - `%` is the stop code ER (tracks 1, 2, 4): it stands where ISO code has `%`. One source prints 5B instead,
///   which no control confirms.
/// - `(` and `)` are a custom of control makers, 2-4-5 and 2-4-7, not glyphs of the first RS-244.
/// - `&` rests on one source.
/// - One source prints the tab as 33, which has four holes and cannot be right in a code of odd parity.
pub const ROWS: [(u8, u8, &str); 50] = [
    (0x00, 0x00, "blank tape"),
    (0x08, 0x2A, "backspace"),
    (0x09, 0x3E, "tabulation"),
    (0x7F, 0x7F, "delete"),
    (b' ', 0x10, "space"),
    (b'%', 0x0B, "stop code, for program start"),
    (b'&', 0x0E, "ampersand"),
    (b'(', 0x1A, "control out"),
    (b')', 0x4A, "control in"),
    (b'+', 0x70, "plus"),
    (b',', 0x3B, "comma"),
    (b'-', 0x40, "minus"),
    (b'.', 0x6B, "decimal point"),
    (b'/', 0x31, "optional block skip"),
    (b'0', 0x20, "digit"),
    (b'1', 0x01, "digit"),
    (b'2', 0x02, "digit"),
    (b'3', 0x13, "digit"),
    (b'4', 0x04, "digit"),
    (b'5', 0x15, "digit"),
    (b'6', 0x16, "digit"),
    (b'7', 0x07, "digit"),
    (b'8', 0x08, "digit"),
    (b'9', 0x19, "digit"),
    (b'A', 0x61, "letter"),
    (b'B', 0x62, "letter"),
    (b'C', 0x73, "letter"),
    (b'D', 0x64, "letter"),
    (b'E', 0x75, "letter"),
    (b'F', 0x76, "letter"),
    (b'G', 0x67, "letter"),
    (b'H', 0x68, "letter"),
    (b'I', 0x79, "letter"),
    (b'J', 0x51, "letter"),
    (b'K', 0x52, "letter"),
    (b'L', 0x43, "letter"),
    (b'M', 0x54, "letter"),
    (b'N', 0x45, "letter"),
    (b'O', 0x46, "letter"),
    (b'P', 0x57, "letter"),
    (b'Q', 0x58, "letter"),
    (b'R', 0x49, "letter"),
    (b'S', 0x32, "letter"),
    (b'T', 0x23, "letter"),
    (b'U', 0x34, "letter"),
    (b'V', 0x25, "letter"),
    (b'W', 0x26, "letter"),
    (b'X', 0x37, "letter"),
    (b'Y', 0x38, "letter"),
    (b'Z', 0x29, "letter"),
];

/// Rows that a typewriter punches and a control disregards: row, label, name.
pub const SHIFTS: [(u8, &str, &str); 2] = [(0x7C, "UC", "upper case shift"), (0x7A, "LC", "lower case shift")];

/// The row of an ASCII character: `None` if the code lacks it.
pub(super) fn row(ascii: u8) -> Option<u8> {
    const BY_ASCII: [Option<u8>; 128] = {
        let mut rows = [None; 128];
        let mut index = 0;
        while index < ROWS.len() {
            rows[ROWS[index].0 as usize] = Some(ROWS[index].1);
            index += 1;
        }
        rows
    };
    BY_ASCII.get(usize::from(ascii)).copied().flatten()
}

/// The ASCII stand-in of a row: `None` for the end of block, shifts and rows without meaning.
pub(super) fn ascii(row: u8) -> Option<u8> {
    ROWS.iter().find(|entry| entry.1 == row).map(|entry| entry.0)
}

/// Label and name of a row.
pub(super) fn meaning(row: u8) -> Option<(String, &'static str)> {
    if row == END_OF_BLOCK {
        return Some(("EOB".to_owned(), "end of block"));
    }
    if let Some((_, label, name)) = SHIFTS.iter().find(|shift| shift.0 == row) {
        return Some(((*label).to_owned(), name));
    }
    ROWS.iter().find(|entry| entry.1 == row).map(|&(ascii, _, name)| {
        let label = match ascii {
            0x00 => String::new(),
            0x08 => "BS".to_owned(),
            0x09 => "TAB".to_owned(),
            0x7F => "DEL".to_owned(),
            b' ' => "SP".to_owned(),
            _ => char::from(ascii).to_string(),
        };
        (label, name)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The construction that every source agrees on: the digit in tracks 1 to 4, the zone in 6 and 7, and track 5
    /// where the holes would otherwise be even.
    fn built(zone: u8, digit: u8) -> u8 {
        let holes = zone | digit;
        if holes.count_ones().is_multiple_of(2) { holes | 0x10 } else { holes }
    }

    #[test]
    fn digits_and_letters_follow_the_construction() {
        assert_eq!(row(b'0'), Some(built(0x20, 0)));
        for (digit, ascii) in (b'1'..=b'9').enumerate() {
            assert_eq!(row(ascii), Some(built(0, digit as u8 + 1)));
        }
        for (digit, ascii) in (b'A'..=b'I').enumerate() {
            assert_eq!(row(ascii), Some(built(0x60, digit as u8 + 1)));
        }
        for (digit, ascii) in (b'J'..=b'R').enumerate() {
            assert_eq!(row(ascii), Some(built(0x40, digit as u8 + 1)));
        }
        for (digit, ascii) in (b'S'..=b'Z').enumerate() {
            assert_eq!(row(ascii), Some(built(0x20, digit as u8 + 2)));
        }
    }

    #[test]
    fn all_rows_but_blank_are_odd_and_distinct() {
        let mut rows: Vec<u8> =
            ROWS.iter().map(|entry| entry.1).chain(SHIFTS.map(|s| s.0)).chain([END_OF_BLOCK]).collect();
        assert!(rows.iter().all(|&row| row == 0 || row.count_ones() % 2 == 1));
        let count = rows.len();
        rows.sort_unstable();
        rows.dedup();
        // 52 codes and blank.
        assert_eq!((rows.len(), count), (53, 53));
    }
}
