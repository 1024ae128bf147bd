//! Today's decimal G-code, line by line.

use std::ops::Range;

/// One line.
#[derive(Debug, Default)]
pub(super) struct Line<'a> {
    /// Bytes of the text, without the line end.
    pub range: Range<usize>,
    /// Block delete heads it.
    pub skip: bool,
    pub words: Vec<Word>,
    pub comments: Vec<&'a str>,
    /// What is no word: the rest of the line is not read.
    pub stray: Option<Range<usize>>,
}

/// A letter and its number.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Word {
    /// In upper case.
    pub letter: char,
    pub value: f64,
    pub range: Range<usize>,
}

impl Word {
    /// The number of a function in tenths: 51 for G5.1.
    pub(super) fn tenths(&self) -> Option<u16> {
        let tenths = self.value * 10.0;
        let whole = tenths.round();
        ((tenths - whole).abs() < 1e-6 && (0.0..=9999.0).contains(&whole)).then_some(whole as u16)
    }
}

/// All lines of a text.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut at = 0;
    text.split_inclusive('\n').flat_map(|line| line.split_inclusive('\r')).map(move |whole| {
        let from = at;
        at += whole.len();
        read(text, from..from + whole.trim_end_matches(['\n', '\r']).len())
    })
}

fn read(text: &str, range: Range<usize>) -> Line<'_> {
    let mut line = Line { range: range.clone(), ..Line::default() };
    let mut at = range.start;
    let bytes = text.as_bytes();
    while at < range.end {
        match bytes[at] {
            b' ' | b'\t' | b'%' => at += 1,
            b'/' if line.words.is_empty() => {
                line.skip = true;
                at += 1;
            }
            b';' => {
                line.comments.push(&text[at + 1..range.end]);
                break;
            }
            b'(' => {
                let end = text[at..range.end].find(')').map_or(range.end, |length| at + length);
                line.comments.push(&text[at + 1..end]);
                at = (end + 1).min(range.end);
            }
            letter if letter.is_ascii_alphabetic() => match number(text, at + 1, range.end) {
                Some((value, end)) => {
                    line.words.push(Word { letter: char::from(letter.to_ascii_uppercase()), value, range: at..end });
                    at = end;
                }
                None => {
                    line.stray = Some(at..range.end);
                    break;
                }
            },
            _ => {
                line.stray = Some(at..range.end);
                break;
            }
        }
    }
    line
}

/// A decimal number from a byte on, blanks before it left aside: its value and the byte behind it.
fn number(text: &str, from: usize, end: usize) -> Option<(f64, usize)> {
    let rest = &text[from..end];
    let start = from + rest.len() - rest.trim_start_matches([' ', '\t']).len();
    let wanted = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-');
    let length = text[start..end].find(|c| !wanted(c)).unwrap_or(end - start);
    let value: f64 = text[start..start + length].parse().ok()?;
    value.is_finite().then_some((value, start + length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_words_and_comments() {
        let text = "/n10 g5.1 X-1.5(a) y .5 ;rest\r\nG1 X#1\n%\n";
        let all: Vec<Line<'_>> = lines(text).collect();
        let words: Vec<(char, f64)> = all[0].words.iter().map(|word| (word.letter, word.value)).collect();
        assert_eq!(words, [('N', 10.0), ('G', 5.1), ('X', -1.5), ('Y', 0.5)]);
        assert_eq!((all[0].skip, all[0].comments.clone()), (true, vec!["a", "rest"]));
        assert_eq!(all[0].words[1].tenths(), Some(51));
        let stray = all.iter().find_map(|line| line.stray.clone()).expect("a parameter");
        assert_eq!(&text[stray], "X#1");
    }
}
