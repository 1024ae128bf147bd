//! Offsets: bytes inside, UTF-16 code units outside; lines and columns.

use std::ops::Range;

/// Where bytes and UTF-16 code units of a text part, and where its lines begin.
///
/// A text of ASCII alone needs no table: its offsets are the same in both.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Offsets {
    /// The characters beyond ASCII.
    wide: Vec<Wide>,
    /// The code unit at which each line begins.
    lines: Vec<usize>,
    length: usize,
}

/// A character beyond ASCII: where it stands in bytes and in code units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Wide {
    byte: usize,
    byte_end: usize,
    unit: usize,
    unit_end: usize,
}

impl Offsets {
    pub(crate) fn new(text: &str) -> Offsets {
        let (wide, lines, _) = scan(text, 0, 0);
        Offsets { wide, lines: [0].into_iter().chain(lines).collect(), length: text.len() }
    }

    /// What an edit between two code units of a text replaces, in bytes, and by what. Where an end lies within a
    /// surrogate pair, the half that stays becomes U+FFFD, as JavaScript shows it.
    pub(crate) fn edit_in_bytes(&self, text: &str, from: u32, to: u32, insert: &str) -> (Range<usize>, String) {
        let (start, splits_start) = self.byte(from as usize);
        let (end, splits_end) = self.byte(to.max(from) as usize);
        let pair = |at: usize| text[at..].chars().next().map_or(at, |c| at + c.len_utf8());
        let end = if splits_end { pair(end) } else { end.max(start) };
        let half = |splits: bool| if splits { "\u{FFFD}" } else { "" };
        (start..end, format!("{}{insert}{}", half(splits_start), half(splits_end)))
    }

    /// Follows an edit: `removed` bytes at byte `at` gave way to `inserted` ones, which makes `text`.
    pub(crate) fn edit(&mut self, text: &str, at: usize, removed: usize, inserted: usize) {
        let bytes = text.as_bytes();
        // The two halves of a CR LF belong to one line end.
        let from = if at > 0 && bytes[at - 1] == b'\r' { at - 1 } else { at };
        let joint = usize::from(bytes.get(at + inserted) == Some(&b'\n'));
        let (old_end, end) = (at + removed + joint, at + inserted + joint);
        let (first_unit, old_unit) = (self.utf16(from), self.utf16(old_end));
        let (wide, lines, unit) = scan(&text[from..end], from, first_unit);

        let line = |unit: usize| self.lines.partition_point(|&start| start <= unit);
        let (first, last) = (line(first_unit), line(old_unit));
        self.lines[last..].iter_mut().for_each(|start| *start = *start - old_unit + unit);
        self.lines.splice(first..last, lines);

        let first = self.wide.partition_point(|wide| wide.byte < from);
        let last = self.wide.partition_point(|wide| wide.byte < old_end);
        for wide in &mut self.wide[last..] {
            wide.byte = wide.byte - old_end + end;
            wide.byte_end = wide.byte_end - old_end + end;
            wide.unit = wide.unit - old_unit + unit;
            wide.unit_end = wide.unit_end - old_unit + unit;
        }
        self.wide.splice(first..last, wide);
        self.length = text.len();
    }

    /// The code unit at a byte that is on a character boundary.
    pub(crate) fn utf16(&self, byte: usize) -> usize {
        match self.wide.partition_point(|wide| wide.byte_end <= byte).checked_sub(1) {
            Some(index) => byte - self.wide[index].byte_end + self.wide[index].unit_end,
            None => byte,
        }
    }

    /// The character boundary at or before a code unit, in bytes, and whether the unit is the second half of a
    /// surrogate pair. Beyond the end it is the end.
    pub(crate) fn byte(&self, unit: usize) -> (usize, bool) {
        let behind = self.wide.partition_point(|wide| wide.unit_end <= unit);
        match self.wide.get(behind) {
            Some(wide) if wide.unit < unit => (wide.byte, true),
            _ => match behind.checked_sub(1) {
                Some(index) => {
                    let byte = (unit - self.wide[index].unit_end).saturating_add(self.wide[index].byte_end);
                    (byte.min(self.length), false)
                }
                None => (unit.min(self.length), false),
            },
        }
    }

    /// Line and column of a code unit, from 1.
    pub(crate) fn line_column(&self, unit: usize) -> (usize, usize) {
        let line = self.lines.partition_point(|&start| start <= unit);
        (line, unit - self.lines[line - 1] + 1)
    }
}

/// The characters beyond ASCII and the beginnings of lines of a stretch that begins at a byte and a unit, and the unit
/// behind it. The line at its start is another's.
fn scan(stretch: &str, from: usize, first_unit: usize) -> (Vec<Wide>, Vec<usize>, usize) {
    let (mut wide, mut lines) = (Vec::new(), Vec::new());
    let mut unit = first_unit;
    let mut after_return = false;
    for (byte, character) in stretch.char_indices() {
        let unit_end = unit + character.len_utf16();
        if !character.is_ascii() {
            wide.push(Wide { byte: from + byte, byte_end: from + byte + character.len_utf8(), unit, unit_end });
        }
        match (character, lines.last_mut()) {
            ('\n', Some(line)) if after_return => *line = unit_end,
            ('\n' | '\r', _) => lines.push(unit_end),
            _ => {}
        }
        after_return = character == '\r';
        unit = unit_end;
    }
    (wide, lines, unit)
}

#[cfg(test)]
mod tests {
    use super::Offsets;

    #[test]
    fn an_edit_leaves_what_a_fresh_table_would_be() {
        let pieces = ["", "\r", "\n", "\r\n", "a", "\u{E9}", "\u{1F600}", "\n\r", "b\r"];
        let boundaries: Vec<usize> = (0..=TEXT.len()).filter(|&at| TEXT.is_char_boundary(at)).collect();
        for &from in &boundaries {
            for &to in boundaries.iter().filter(|&&to| to >= from) {
                for insert in pieces {
                    let text = format!("{}{insert}{}", &TEXT[..from], &TEXT[to..]);
                    let mut offsets = Offsets::new(TEXT);
                    offsets.edit(&text, from, to - from, insert.len());
                    assert_eq!(offsets, Offsets::new(&text), "{from}..{to} {insert:?}");
                }
            }
        }
    }

    const TEXT: &str = "a\u{00E9}b\r\n\u{2212}\u{1F600}c\rd\ne";

    #[test]
    fn offsets_agree_with_the_text_encoded_in_utf_16() {
        let offsets = Offsets::new(TEXT);
        for (byte, _) in TEXT.char_indices().chain([(TEXT.len(), ' ')]) {
            let unit = TEXT[..byte].encode_utf16().count();
            assert_eq!(offsets.utf16(byte), unit);
            assert_eq!(offsets.byte(unit), (byte, false));
        }
        assert_eq!(offsets.byte(usize::MAX), (TEXT.len(), false), "beyond the end it is the end");
        assert_eq!(Offsets::new("N1").byte(usize::MAX), (2, false));
    }

    #[test]
    fn the_second_half_of_a_pair_is_told() {
        let pair = TEXT.find('\u{1F600}').unwrap_or(0);
        let unit = TEXT[..pair].encode_utf16().count();
        assert_eq!(Offsets::new(TEXT).byte(unit + 1), (pair, true));
    }

    #[test]
    fn every_kind_of_line_end_begins_one_line() {
        let offsets = Offsets::new(TEXT);
        let at = |character: char| {
            let byte = TEXT.find(character).unwrap_or(0);
            offsets.line_column(offsets.utf16(byte))
        };
        assert_eq!(at('a'), (1, 1));
        assert_eq!(at('b'), (1, 3));
        assert_eq!(at('c'), (2, 4));
        assert_eq!(at('d'), (3, 1));
        assert_eq!(at('e'), (4, 1));
    }
}
