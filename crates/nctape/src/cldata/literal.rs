//! Literals (5.7): from an apostrophe to the next that is not doubled.

use super::characters::{is_layout, is_quote};
use super::reader::Reader;
use super::record::Slip;
use std::ops::Range;

impl Reader<'_> {
    /// Finds the end of the literal that begins here, and notes what is to be said of it.
    pub(super) fn literal(&mut self, quote: char) -> usize {
        let from = self.at;
        let inside = from + quote.len_utf8();
        // A literal that begins with an apostrophe as the standard prints it ends with one; one that begins with
        // ISO/IEC 646's ends with that, and may hold the other as a character.
        let typographic = quote != '\'';
        let closing = self.closing(inside, typographic);
        let line = self.breaks_in_literal(inside, closing.as_ref().map_or(self.bytes.len(), |close| close.start));
        let Some(close) = closing.filter(|_| line.is_none()) else {
            let line = line.or_else(|| self.stream.next_line(inside)).unwrap_or(self.bytes.len());
            let to = self.before_separator(inside, line);
            self.note(Slip::Unclosed, from..to);
            return to;
        };
        if typographic {
            self.note_typographic(from..inside, '\'');
        }
        if self.character(close.start) != Some('\'') {
            self.note_typographic(close.clone(), '\'');
        }
        self.note_inside(inside..close.start, from..close.end, typographic);
        close.end
    }

    /// The apostrophe that closes a literal; a doubled one does not (5.7.4 note 4).
    fn closing(&self, inside: usize, typographic: bool) -> Option<Range<usize>> {
        let closes = |character: char| character == '\'' || typographic && is_quote(character);
        let mut at = inside;
        loop {
            let start = at + self.stream.text[at..].find(closes)?;
            let end = start + self.character(start).map_or(1, char::len_utf8);
            match self.character(end).filter(|next| closes(*next)) {
                Some(second) => at = end + second.len_utf8(),
                None => return Some(start..end),
            }
        }
    }

    /// Where a line begins within a literal with what can only be the next record: the literal was never closed.
    fn breaks_in_literal(&self, inside: usize, to: usize) -> Option<usize> {
        let mut line = self.stream.next_line(inside)?;
        while line < to {
            let begins = line + self.bytes[line..].iter().take_while(|byte| is_layout(**byte)).count();
            if self.begins_next_record(begins) {
                return Some(line);
            }
            line = self.stream.next_line(line)?;
        }
        None
    }

    /// Where a literal without its apostrophe ends: before the separator that ends its line, or with the line.
    fn before_separator(&self, inside: usize, line: usize) -> usize {
        let text = self.stream.text[inside..line].trim_end();
        let text = text.strip_suffix(':').map_or(text, str::trim_end);
        inside + text.strip_suffix(';').unwrap_or(text).trim_end().len()
    }

    /// What a literal holds that is worth saying: characters beyond ISO/IEC 646, line ends.
    fn note_inside(&mut self, inside: Range<usize>, whole: Range<usize>, typographic: bool) {
        let text = &self.stream.text[inside.clone()];
        if typographic {
            for (at, quote) in text.char_indices().filter(|(_, character)| is_quote(*character) && *character != '\'') {
                self.note_typographic(inside.start + at..inside.start + at + quote.len_utf8(), '\'');
            }
        }
        let is_beyond = |character: char| !(character.is_ascii() || typographic && is_quote(character));
        let beyond = text.chars().filter(|character| is_beyond(*character)).count();
        if let Some(first) = text.find(is_beyond) {
            let last = text.rfind(is_beyond).unwrap_or(first);
            let width = text[last..].chars().next().map_or(1, char::len_utf8);
            let range = inside.start + first..inside.start + last + width;
            self.note(Slip::Beyond { count: beyond, literal: true }, range);
        }
        let line_end = self.stream.text[inside.clone()].find(['\n', '\r']);
        if let Some(end) = line_end.filter(|_| !self.stream.is_of_columns()) {
            let before = &self.stream.text[..inside.start + end];
            let start = before.rfind(['\n', '\r']).map_or(0, |at| at + 1);
            let width = before[start..].chars().count();
            self.note(Slip::LineEnd { width }, whole);
        }
    }
}
