//! Which code a tape is in.
//!
//! The codes can be told apart because no row is a character of both: every row of EIA code has an odd number of holes,
//! every row of ISO code an even one. Controls decide by the first end-of-block row.

use super::Code;

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
    let plain = punched.iter().all(|row| row & 0x80 == 0) && punched.contains(&0x0A) && even < punched.len();
    if plain {
        let reason = "Track 8 is never punched and the end of block is a line feed: this is 7-bit ASCII without parity. \
                      It is read as ISO 840; the rows with an odd number of holes are reported.";
        return (Code::Iso, reason.to_owned());
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
