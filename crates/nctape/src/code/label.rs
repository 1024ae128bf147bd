//! Letters for people on a tape that is read: where they are, so that none of their rows is taken for a character.

use super::Code;
use std::ops::Range;

/// So many blank rows part a label from what stands before or behind it. Letters and words stand closer.
const GAP: usize = 6;

/// The labels before the first end of block and behind the last, `program` being the rows from the one to the other.
///
/// A label is a stretch between gaps of blank tape in which a quarter of the rows or more are no characters. Some rows
/// of a letter always happen to be characters, so the whole stretch is passed over, not its unreadable rows alone. A
/// single letter may be made of nothing else, as an H in EIA code; it is read as what it is.
pub(super) fn labels(rows: &[u8], code: Code, program: &Range<usize>) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    if program.is_empty() {
        return found;
    }
    for outside in [0..program.start, program.end + 1..rows.len()] {
        for stretch in stretches(rows, outside.clone()) {
            // What touches the program without a gap belongs to it: its % and its number.
            if stretch.end == program.start || (stretch.start == program.end + 1 && outside.start > 0) {
                continue;
            }
            let punched = rows[stretch.clone()].iter().filter(|&&row| row != 0).count();
            let strange = rows[stretch.clone()].iter().filter(|&&row| code.meaning(row).is_none()).count();
            if 4 * strange >= punched {
                found.push(stretch);
            }
        }
    }
    found
}

/// Rows with holes, parted by gaps of blank tape.
fn stretches(rows: &[u8], within: Range<usize>) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    for row in within.filter(|&row| rows[row] != 0) {
        match found.last_mut() {
            Some(last) if row - last.end < GAP => last.end = row + 1,
            _ => found.push(row..row + 1),
        }
    }
    found
}
