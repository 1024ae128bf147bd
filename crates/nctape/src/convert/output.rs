//! The text of a conversion as it grows, line by line, with what each block gave.

use std::fmt::Write;
use std::ops::Range;

/// The lines that blocks give.
#[derive(Default)]
pub(super) struct Output {
    pub text: String,
    pub map: Vec<(Range<usize>, Range<usize>)>,
    /// Put before every line of the block: the character of block delete.
    skip: bool,
    /// The sequence number that the first line of the block gets.
    number: Option<String>,
    /// Where the lines of the block begin.
    start: usize,
}

impl Output {
    /// What follows is of another block.
    pub(super) fn begin(&mut self, skip: bool, number: Option<String>) {
        (self.skip, self.number, self.start) = (skip, number, self.text.len());
    }

    /// Adds a line of words.
    pub(super) fn line(&mut self, words: &str) {
        if self.skip {
            self.text.push('/');
        }
        if let Some(number) = self.number.take() {
            // Writing to a string cannot fail.
            let _ = write!(self.text, "N{number}{}", if words.is_empty() { "" } else { " " });
        }
        self.text.push_str(words);
        self.text.push('\n');
    }

    /// Adds lines of comment.
    pub(super) fn comment(&mut self, text: &str) {
        for line in super::linuxcnc::comment_lines(text) {
            self.text.push_str(&line);
            self.text.push('\n');
        }
    }

    /// The block whose characters these are ends: a sequence number that no line has got stands alone. Tells its lines.
    pub(super) fn end(&mut self, source: Range<usize>) -> Range<usize> {
        if self.number.is_some() {
            self.line("");
        }
        let lines = self.start..self.text.len();
        self.map.push((source, lines.clone()));
        lines
    }

    /// Another block has a part in lines that the last one gave.
    pub(super) fn link(&mut self, source: Range<usize>, lines: Range<usize>) {
        self.map.push((source, lines));
    }
}
