//! Which code a tape is in.
//!
//! The codes can be told apart because no row is a character of both: every row of EIA code has an odd number of holes,
//! every row of ISO code an even one. Controls decide by the first end-of-block row.

use super::Code;
use super::iso840::with_parity;

/// How track 8 of a tape in ISO code is punched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Track8 {
    /// For even parity, as ISO 840 wants it.
    Parity,
    /// Never: seven-bit characters without parity.
    Never,
    /// In every row: mark parity, as some teleprinters punch it.
    Always,
}

/// How track 8 is punched, supposing that the tape is in ISO code.
///
/// Of seven-bit characters about half have an odd number of holes, so that track 8 never or always punched leaves the
/// parity wrong in many rows. A few such rows are damage: a single row never changes what is found here.
pub(super) fn track_8(rows: &[u8]) -> Track8 {
    let is_fill = |row: u8| matches!(row, 0x00 | 0x7F | 0x80 | 0xFF);
    let punched = || rows.iter().copied().filter(|&row| !is_fill(row));
    let (count, odd) = punched().fold((0, 0), |(count, odd), row| (count + 1, odd + row.count_ones() as usize % 2));
    let (few, most) = (2.max(count / 8), count - count / 8);
    if odd < few || odd > most {
        return Track8::Parity;
    }
    let ends = |end: u8, by_return: u8| punched().any(|row| row == end || row == by_return);
    match () {
        () if rows.iter().all(|row| row & 0x80 == 0) && ends(0x0A, 0x0D) => Track8::Never,
        () if punched().all(|row| row & 0x80 != 0) && ends(0x8A, 0x8D) => Track8::Always,
        () => Track8::Parity,
    }
}

impl Track8 {
    /// A row as it would be with even parity on track 8.
    pub(super) fn mended(self, row: u8) -> u8 {
        if self == Track8::Parity { row } else { with_parity(row & 0x7F) }
    }
}

/// The code of a tape and why, in words.
pub(super) fn recognise(rows: &[u8]) -> (Code, String) {
    let is_fill = |row: &u8| matches!(row, 0x00 | 0x7F | 0xFF);
    // What stands before the first end of block may be letters for people, which have the parity of neither code.
    let is_end = |row: &u8| matches!(row, 0x80 | 0x0A | 0x8D);
    let rows = &rows[rows.iter().position(is_end).unwrap_or(0)..];
    let punched: Vec<u8> = rows.iter().copied().filter(|row| !is_fill(row)).collect();
    if punched.is_empty() {
        return (Code::Iso, "There is no character on the tape; ISO 840 is assumed.".to_owned());
    }
    let share = |code: Code| {
        let fitting = punched.iter().filter(|&&row| code.parity_fits(row)).count();
        format!("{} of {} rows have its parity", fitting, punched.len())
    };
    let first = punched.iter().find_map(|row| match row {
        0x80 => Some(Code::Eia),
        0x0A | 0x8D => Some(Code::Iso),
        _ => None,
    });
    let even = punched.iter().filter(|&&row| Code::Iso.parity_fits(row)).count();
    let by_parity = if 2 * even >= punched.len() { Code::Iso } else { Code::Eia };
    let without_parity = match track_8(rows) {
        Track8::Parity => None,
        Track8::Never => Some("never punched: these are seven-bit characters without parity"),
        Track8::Always => Some("punched in every row: this is mark parity, as some teleprinters punch it"),
    };
    if let Some(what) = without_parity {
        let reason =
            format!("ISO 840: there are line feeds or carriage returns, but track 8 is {what}. It is passed over.");
        return (Code::Iso, reason);
    }
    match first {
        Some(code) if code == by_parity => {
            let end = if code == Code::Eia { "track 8 alone" } else { "a line feed or carriage return" };
            (code, format!("{}: the first end of block is {end}, and {}.", code.name(), share(code)))
        }
        Some(code) => (
            code,
            format!(
                "{}: the first end of block says so, but only {}. The tape may be turned over or damaged.",
                code.name(),
                share(code)
            ),
        ),
        None => {
            let mirrored = punched.iter().filter(|row| matches!(row.reverse_bits(), 0x80 | 0x0A)).count();
            let hint = if mirrored > 0 {
                " Read with the tracks in the other order there are some: turn the tape over."
            } else {
                ""
            };
            (by_parity, format!("{}: there is no end of block, but {}.{hint}", by_parity.name(), share(by_parity)))
        }
    }
}
