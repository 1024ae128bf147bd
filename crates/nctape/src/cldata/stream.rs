//! The text as one stream of characters (ISO 3592 annex A): as it is, or as the columns of records of a fixed length.
//!
//! On a medium of records, a literal that reaches the last column goes on in the first column of the next record
//! (5.7.4), and a short line is a record filled with blanks. So the stream is every line, filled up to that column, and
//! one behind the other: the line ends are gone, and what stands behind the last column is not of the language.

use std::borrow::Cow;
use std::ops::Range;

/// A text to be read.
#[derive(Clone, Debug, Default)]
pub(super) struct Stream<'a> {
    /// What is read.
    pub text: Cow<'a, str>,
    /// Where the lines are that it was made of; none where it is the text as it is.
    lines: Vec<Line>,
}

/// A line: where it begins in the stream and in the text, and how many bytes of it were taken.
#[derive(Clone, Copy, Debug)]
struct Line {
    stream: usize,
    text: usize,
    taken: usize,
}

impl<'a> Stream<'a> {
    /// The text as it is.
    pub fn of_text(text: &'a str) -> Stream<'a> {
        // Places are 32 bits wide; what lies beyond four gigabytes is not read.
        let end = text.floor_char_boundary(u32::MAX as usize - 1);
        Stream { text: Cow::Borrowed(&text[..end]), lines: Vec::new() }
    }

    /// The text as records of so many columns. A tabulator is one column.
    pub fn of_columns(text: &'a str, columns: usize) -> Stream<'a> {
        let (mut stream, mut lines, mut at) = (String::with_capacity(text.len()), Vec::new(), 0);
        for line in text.split_inclusive('\n') {
            let content = line.trim_end_matches(['\n', '\r']);
            let taken = content.char_indices().nth(columns).map_or(content.len(), |(byte, _)| byte);
            if stream.len() + taken + columns >= u32::MAX as usize {
                break;
            }
            lines.push(Line { stream: stream.len(), text: at, taken });
            stream.push_str(&content[..taken]);
            let filled = content[..taken].chars().count();
            stream.extend(std::iter::repeat_n(' ', columns - filled.min(columns)));
            at += line.len();
        }
        Stream { text: Cow::Owned(stream), lines }
    }

    /// The same, on its own.
    pub fn into_owned(self) -> Stream<'static> {
        Stream { text: Cow::Owned(self.text.into_owned()), lines: self.lines }
    }

    /// Where a place of the stream is in the text.
    pub fn in_text(&self, at: usize) -> usize {
        match self.lines.partition_point(|line| line.stream <= at).checked_sub(1) {
            Some(index) => self.lines[index].text + (at - self.lines[index].stream).min(self.lines[index].taken),
            None => at,
        }
    }

    /// Where a stretch of the stream is in the text. An end that is the start of a line is the end of the line before.
    pub fn range_in_text(&self, range: &Range<usize>) -> Range<usize> {
        let from = self.in_text(range.start);
        let to = if range.end > range.start && !self.lines.is_empty() {
            let index = self.lines.partition_point(|line| line.stream < range.end).saturating_sub(1);
            let line = self.lines[index];
            line.text + (range.end - line.stream).min(line.taken)
        } else {
            self.in_text(range.end)
        };
        from..to.max(from)
    }

    /// Whether the lines are records of a fixed length.
    pub fn is_of_columns(&self) -> bool {
        !self.lines.is_empty()
    }

    /// Where the line behind a place begins in the stream.
    pub fn next_line(&self, at: usize) -> Option<usize> {
        if self.is_of_columns() {
            let index = self.lines.partition_point(|line| line.stream <= at);
            return self.lines.get(index).map(|line| line.stream);
        }
        let found = self.text.as_bytes()[at..].iter().position(|byte| matches!(byte, b'\n' | b'\r'))?;
        Some(at + found + 1)
    }

    /// Whether a line begins at a place of the stream, or between one place and another of it.
    pub fn line_begins_in(&self, range: Range<usize>) -> bool {
        if self.is_of_columns() {
            let index = self.lines.partition_point(|line| line.stream <= range.start);
            return self.lines.get(index).is_some_and(|line| line.stream <= range.end);
        }
        self.text.as_bytes()[range].iter().any(|byte| matches!(byte, b'\n' | b'\r'))
    }

    /// How many columns more a line of the text may hold, and whether it holds anything behind the last column; where
    /// there are columns.
    pub fn room(&self, at: usize, text: &str, columns: usize) -> usize {
        let index = self.lines.partition_point(|line| line.text <= at).saturating_sub(1);
        let Some(line) = self.lines.get(index) else { return usize::MAX };
        let behind = text[line.text + line.taken..].chars().next().is_none_or(|next| matches!(next, '\n' | '\r'));
        let filled = text[line.text..line.text + line.taken].chars().count();
        if behind { columns.saturating_sub(filled) } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::Stream;

    #[test]
    fn lines_are_filled_and_joined_and_their_places_lead_back() {
        let text = "1,'ab\ncdefgh99\r\n;";
        let stream = Stream::of_columns(text, 6);
        assert_eq!(stream.text, "1,'ab cdefgh;     ");
        let places: Vec<usize> = [0, 4, 5, 6, 11, 12].into_iter().map(|at| stream.in_text(at)).collect();
        assert_eq!(places, [0, 4, 5, 6, 11, 16]);
        assert_eq!(stream.range_in_text(&(6..12)), 6..12);
        assert!(stream.line_begins_in(5..6) && !stream.line_begins_in(7..11));
        assert_eq!(stream.next_line(1), Some(6));
        assert_eq!((stream.room(0, text, 6), stream.room(7, text, 6)), (1, 0));
    }

    #[test]
    fn a_text_is_its_own_stream() {
        let stream = Stream::of_text("1,\n2");
        assert_eq!(stream.range_in_text(&(1..3)), 1..3);
        assert!(stream.line_begins_in(1..3) && !stream.line_begins_in(0..2));
        assert_eq!((stream.next_line(0), stream.next_line(3)), (Some(3), None));
    }
}
