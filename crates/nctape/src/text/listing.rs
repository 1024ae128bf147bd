//! From the characters of a listing to the characters of a tape.

/// What a character of the tape is, apart from its place in the listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// End of block: a line end (LF, CR LF, CR), `*`, or `*` with a line end right behind it.
    EndOfBlock,
    /// Any other character that is punched, as it stands in the listing.
    Character(char),
}

/// One character of the tape and the bytes of the listing that it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TapeCharacter {
    /// What it is.
    pub mark: Mark,
    /// First byte in the listing.
    pub from: usize,
    /// Byte behind the last one.
    pub to: usize,
    /// It stands in a comment; the parentheses themselves do not.
    pub comment: bool,
}

/// Walks over a listing character of the tape by character of the tape.
///
/// Blanks outside comments are layout: they have no hole and are left out. A comment runs from `(` to the next
/// `)`, across line ends; inside it a blank is punched, and a line end is punched as an end-of-block character
/// that ends no block.
///
/// ```
/// use nctape::text::{Listing, Mark};
/// let marks: Vec<Mark> = Listing::new("N1 *\r\n").map(|c| c.mark).collect();
/// assert_eq!(marks, [Mark::Character('N'), Mark::Character('1'), Mark::EndOfBlock]);
/// ```
#[derive(Clone, Debug)]
pub struct Listing<'a> {
    text: &'a str,
    at: usize,
    comment: bool,
}

impl<'a> Listing<'a> {
    /// Starts at the beginning of a listing.
    pub fn new(text: &'a str) -> Self {
        Listing { text, at: 0, comment: false }
    }

    /// Takes the digits that follow with nothing between them.
    #[inline]
    pub(crate) fn digits(&mut self) -> &'a [u8] {
        let rest = &self.text.as_bytes()[self.at..];
        let count = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        self.at += count;
        &rest[..count]
    }

    /// Starts at byte `at`, which must be on a character boundary; `comment` tells whether a comment is open there.
    pub(crate) fn resume(text: &'a str, at: usize, comment: bool) -> Self {
        Listing { text, at, comment }
    }
}

impl Iterator for Listing<'_> {
    type Item = TapeCharacter;

    #[inline]
    fn next(&mut self) -> Option<TapeCharacter> {
        let bytes = self.text.as_bytes();
        let mut from = self.at;
        let mut byte = *bytes.get(from)?;
        while byte == b' ' && !self.comment {
            from += 1;
            let Some(&next) = bytes.get(from) else {
                self.at = from;
                return None;
            };
            byte = next;
        }
        let mut to = from + 1;
        let comment = self.comment && byte != b')';
        let mark = match byte {
            b'\n' | b'\r' | b'*' => {
                to = end_of_block_end(bytes, from);
                Mark::EndOfBlock
            }
            0x80.. => {
                let character = self.text[from..].chars().next()?;
                to = from + character.len_utf8();
                Mark::Character(character)
            }
            _ => {
                if matches!(byte, b'(' | b')') {
                    self.comment = byte == b'(';
                }
                Mark::Character(char::from(byte))
            }
        };
        self.at = to;
        Some(TapeCharacter { mark, from, to, comment })
    }
}

/// The byte behind the end-of-block character that starts at `from`: `*` takes a line end right behind it with it,
/// CR takes an LF.
fn end_of_block_end(bytes: &[u8], from: usize) -> usize {
    let mut to = from + 1;
    if bytes[from] == b'*' {
        match bytes.get(to) {
            Some(b'\n') => return to + 1,
            Some(b'\r') => to += 1,
            _ => return to,
        }
    } else if bytes[from] == b'\n' {
        return to;
    }
    if bytes.get(to) == Some(&b'\n') { to + 1 } else { to }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(text: &str) -> String {
        Listing::new(text)
            .map(|c| match c.mark {
                Mark::EndOfBlock => '$',
                Mark::Character(c) => c,
            })
            .collect()
    }

    #[test]
    fn every_line_end_and_every_asterisk_is_one_end_of_block() {
        assert_eq!(shape("A\nB\r\nC\rD*E*\nF*\r\nG*\rH**\n\n"), "A$B$C$D$E$F$G$H$$$");
    }

    #[test]
    fn a_blank_is_layout_outside_a_comment_only() {
        assert_eq!(shape("N 1 (A B) X"), "N1(A B)X");
    }

    #[test]
    fn a_comment_runs_across_line_ends() {
        let inside: Vec<bool> = Listing::new("(A\n B)C").map(|c| c.comment).collect();
        assert_eq!(inside, [false, true, true, true, true, false, false]);
    }

    #[test]
    fn ranges_cover_the_listing_but_for_layout() {
        let text = "N1 X*\r\n\u{2212}";
        let ranges: Vec<(usize, usize)> = Listing::new(text).map(|c| (c.from, c.to)).collect();
        assert_eq!(ranges, [(0, 1), (1, 2), (3, 4), (4, 7), (7, 10)]);
    }
}
