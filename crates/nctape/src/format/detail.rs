//! Format classification detailed shorthand: annex D of both standards, and the EIA format detail of Y-1702.

use super::Standard;
use crate::order::order_by_key;
use std::ops::Range;

/// What stands between the address of a dimension word and its digits: D.3.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Nothing: absolute dimensions that are always positive.
    Positive,
    /// `+`: absolute dimensions, positive or negative.
    Signed,
    /// `D`: incremental dimensions.
    Incremental,
    /// `L`: absolute and incremental, ISO 2539 only.
    Both,
}

/// Which zeros of a dimension word may be left out: D.3.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zeros {
    /// None: every digit is punched.
    All,
    /// Three-digit designation that begins with 0.
    LeadingOmitted,
    /// Three-digit designation that ends with 0.
    TrailingOmitted,
}

/// One word of the detail.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Designation {
    /// The address, an upper-case letter.
    pub address: char,
    /// Where the word stands in the detail, without its full stop.
    pub range: Range<usize>,
    /// A full stop stands before it: the word begins with a tab.
    pub tab: bool,
    /// The sign mark as written.
    pub sign: Sign,
    /// The digits as written.
    pub digits: String,
    /// It is a dimension word; otherwise a number without sign.
    pub dimension: bool,
    /// Digits before the implicit decimal sign.
    pub before: u8,
    /// Digits behind the implicit decimal sign.
    pub after: u8,
    /// Zeros that may be left out.
    pub zeros: Zeros,
}

impl Designation {
    /// Digits of the word when every one is punched.
    pub fn width(&self) -> u8 {
        self.before + self.after
    }

    /// A number of so many digits, with this sign, may be a word of this designation.
    pub(crate) fn fits(&self, sign: Option<u8>, digits: u16) -> bool {
        let width = u16::from(self.width());
        let short = self.dimension && self.zeros != Zeros::All;
        let signed = self.dimension && self.sign != Sign::Positive;
        (signed || sign.is_none()) && (digits == width || short && digits < width)
    }

    /// The designation as it is written: "X+42".
    pub fn text(&self) -> String {
        let sign = match self.sign {
            Sign::Positive => "",
            Sign::Signed => "+",
            Sign::Incremental => "D",
            Sign::Both => "L",
        };
        format!("{}{sign}{}", self.address, self.digits)
    }
}

/// A detail, taken apart without judging it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Detail {
    /// Its words in their order.
    pub words: Vec<Designation>,
    /// The asterisk at the end.
    pub end: Option<Range<usize>>,
    /// What stands where nothing is foreseen.
    pub stray: Vec<Range<usize>>,
    /// The length of the text.
    pub length: usize,
}

/// Letters that may be the address of a dimension word: 3.2.2.2.
pub(crate) const DIMENSION_LETTERS: &str = "XYZUVWPQRIJKABCDE";

impl Detail {
    /// Takes a detail apart. Blanks are layout; EIA writes lower case.
    ///
    /// ```
    /// use nctape::format::{Detail, Sign, Standard, Zeros};
    /// let detail = Detail::read("N3.G2.X+042*", Standard::Iso2539);
    /// let x = &detail.words[2];
    /// assert_eq!((x.sign, x.before, x.after, x.zeros), (Sign::Signed, 4, 2, Zeros::LeadingOmitted));
    /// ```
    pub fn read(text: &str, standard: Standard) -> Detail {
        let mut detail = Detail { length: text.len(), ..Detail::default() };
        let places: Vec<(usize, char)> = text.char_indices().filter(|(_, c)| !c.is_whitespace()).collect();
        let mut at = 0;
        // A full stop whose word is still to come.
        let mut tab: Option<Range<usize>> = None;
        let mut previous_stray = None;
        while let Some(&(from, character)) = places.get(at) {
            let here = from..from + character.len_utf8();
            at += 1;
            // A full stop before a digit is no tab: a word begins with its address.
            let digit_follows = places.get(at).is_some_and(|place| place.1.is_ascii_digit());
            if detail.end.is_some() {
                stray(&mut detail.stray, previous_stray == Some(at - 1), here);
                previous_stray = Some(at);
            } else if character == '.' && tab.is_none() && !digit_follows {
                tab = Some(here);
            } else if character == '*' {
                detail.end = Some(here);
                detail.stray.extend(tab.take());
            } else if character.is_ascii_alphabetic() {
                let (marks, digits) = word_length(&places[at..]);
                let length = marks + digits;
                let to = if length == 0 { here.end } else { places[at + length - 1].0 + 1 };
                let body: String = places[at..at + length].iter().map(|place| place.1.to_ascii_uppercase()).collect();
                // The first mark is the word's; what follows it says something else of the same word.
                if marks > 1 {
                    detail.stray.push(places[at + 1].0..places[at + marks - 1].0 + 1);
                }
                at += length;
                let tab = tab.take().is_some();
                detail.words.push(designation(character.to_ascii_uppercase(), from..to, tab, &body, standard));
            } else {
                stray(&mut detail.stray, previous_stray == Some(at - 1), here);
                previous_stray = Some(at);
            }
        }
        detail.stray.extend(tab);
        order_by_key(&mut detail.stray, |range| (range.start, 0));
        detail
    }

    /// Something that means nothing stands between a word and the one before it: what the word lacks may be it.
    pub(crate) fn is_behind_stray(&self, index: usize) -> bool {
        let from = index.checked_sub(1).map_or(0, |before| self.words[before].range.end);
        self.stray.iter().any(|stray| from <= stray.start && stray.end <= self.words[index].range.start)
    }

    /// Something that means nothing stands right behind a word: it may be what cut its digits short.
    pub(crate) fn is_cut_short(&self, word: &Designation) -> bool {
        self.stray.iter().any(|stray| stray.start == word.range.end)
    }
}

/// Notes a character that means nothing; those that stand together are one.
fn stray(strays: &mut Vec<Range<usize>>, goes_on: bool, here: Range<usize>) {
    match strays.last_mut() {
        Some(last) if goes_on => last.end = here.end,
        _ => strays.push(here),
    }
}

/// How many places behind an address belong to its word: sign marks and digits. There is one mark at most; two or
/// more, one of them +, are a slip within one word, for no address is a +.
fn word_length(places: &[(usize, char)]) -> (usize, usize) {
    let digit_at = |index: usize| places.get(index).is_some_and(|place| place.1.is_ascii_digit());
    let is_mark = |place: &&(usize, char)| matches!(place.1.to_ascii_uppercase(), '+' | 'D' | 'L');
    let run = places.iter().take_while(is_mark).count();
    let plus = places[..run].iter().any(|place| place.1 == '+');
    let marks = match run {
        0 => 0,
        2.. if plus && digit_at(run) => run,
        _ => usize::from(digit_at(1)),
    };
    let digits = (marks..).take_while(|&index| digit_at(index)).count();
    (marks, digits)
}

fn designation(address: char, range: Range<usize>, tab: bool, body: &str, standard: Standard) -> Designation {
    let digits = body.trim_start_matches(['+', 'D', 'L']).to_owned();
    let sign = match body.chars().next() {
        Some('+') => Sign::Signed,
        Some('D') => Sign::Incremental,
        Some('L') => Sign::Both,
        _ => Sign::Positive,
    };
    let places: Vec<u8> = digits.bytes().map(|digit| digit - b'0').collect();
    // One digit behind A, B, C, D or E marks a symbolic motion (annex D: B1) or another function: no dimension.
    let dimension = DIMENSION_LETTERS.contains(address) && places.len() >= 2;
    let (before, after, zeros) = match (places.as_slice(), dimension) {
        ([before, after], true) => (*before, *after, Zeros::All),
        ([0, before, after], true) => (*before, *after, Zeros::LeadingOmitted),
        ([before, after, 0], true) => (*before, *after, Zeros::TrailingOmitted),
        // A fault of the format (SPEC-14, NUM-07): read as if nothing might be left out.
        ([before, after, ..], true) => (*before, *after, Zeros::All),
        // Y-1702 gives f21 a decimal sign; ISO has one digit only (SPEC-15).
        ([before, after, ..], false) if standard == Standard::Rs274 => (*before, *after, Zeros::All),
        ([width, ..], false) => (*width, 0, Zeros::All),
        _ => (0, 0, Zeros::All),
    };
    Designation { address, range, tab, sign, digits, dimension, before, after, zeros }
}
