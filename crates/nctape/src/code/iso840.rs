//! ISO 840 in the subset of EIA RS-358: the seven-bit character on tracks 1 to 7, even parity on track 8.
//!
//! Source of the subset: Y-1702 (Miskell, 1969), figure 2, and ISO 2539 annex B, which prints the same characters.
//! Neither has `.` or `,`: ISO 2539 3.3.3.3 forbids the decimal sign.

/// The characters of the subset that have a glyph, in ASCII order.
pub const GLYPHS: &[u8] = b"%()+-/0123456789:ABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// The characters of the subset without a glyph: ASCII value, label, name.
pub const CONTROLS: [(u8, &str, &str); 7] = [
    (0x00, "", "blank tape"),
    (0x08, "BS", "backspace"),
    (0x09, "TAB", "tabulation"),
    (0x0A, "EOB", "end of block (line feed)"),
    (0x0D, "CR", "carriage return"),
    (0x20, "SP", "space"),
    (0x7F, "DEL", "delete"),
];

/// The row of an ASCII character: `None` outside the subset.
pub(super) fn row(ascii: u8) -> Option<u8> {
    const ROWS: [Option<u8>; 128] = {
        let mut rows = [None; 128];
        let mut index = 0;
        while index < GLYPHS.len() {
            rows[GLYPHS[index] as usize] = Some(with_parity(GLYPHS[index]));
            index += 1;
        }
        index = 0;
        while index < CONTROLS.len() {
            rows[CONTROLS[index].0 as usize] = Some(with_parity(CONTROLS[index].0));
            index += 1;
        }
        rows
    };
    ROWS.get(usize::from(ascii)).copied().flatten()
}

/// The ASCII character of a row: `None` outside the subset, or where the parity is wrong.
pub(super) fn ascii(with_track_8: u8) -> Option<u8> {
    let ascii = with_track_8 & 0x7F;
    (row(ascii) == Some(with_track_8)).then_some(ascii)
}

/// Characters that makers of controls added to the subset, and that a tape may hold: the other printing characters of
/// the seven-bit code.
pub(super) fn extension(with_track_8: u8) -> Option<char> {
    let ascii = with_track_8 & 0x7F;
    let added = (0x21..0x7F).contains(&ascii) && row(ascii).is_none() && with_parity(ascii) == with_track_8;
    added.then(|| char::from(ascii))
}

/// Label and name of a row.
pub(super) fn meaning(row: u8) -> Option<(String, &'static str)> {
    let ascii = row & 0x7F;
    if with_parity(ascii) != row {
        return None;
    }
    if let Some((_, label, name)) = CONTROLS.iter().find(|c| c.0 == ascii) {
        return Some(((*label).to_owned(), name));
    }
    GLYPHS.contains(&ascii).then(|| (char::from(ascii).to_string(), name(ascii)))
}

/// Sets track 8 so that the number of holes is even.
pub(super) const fn with_parity(ascii: u8) -> u8 {
    ascii | ((ascii.count_ones() as u8 & 1) << 7)
}

fn name(ascii: u8) -> &'static str {
    match ascii {
        b'0'..=b'9' => "digit",
        b'A'..=b'Z' => "letter",
        b'%' => "program start",
        b'(' => "control out",
        b')' => "control in",
        b'+' => "plus",
        b'-' => "minus",
        b'/' => "optional block skip",
        _ => "alignment function",
    }
}
