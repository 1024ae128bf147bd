//! Records (5.15), files (5.17), and what was noted while they were read.

use super::element::Element;
use std::ops::Range;

/// One record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Record {
    /// The type, its second element; zero where that is no whole number between 1 and 65535.
    pub kind: u16,
    /// The file that it belongs to, from 0.
    pub file: u32,
    /// Its place, in bytes of the stream; the record separator belongs to it.
    pub(super) from: u32,
    pub(super) to: u32,
    /// Its elements in the table of all.
    pub(super) first: u32,
    pub(super) last: u32,
}

impl Record {
    pub(crate) fn range(&self) -> Range<usize> {
        self.from as usize..self.to as usize
    }

    /// Its elements in the table of all.
    pub fn elements(&self) -> Range<usize> {
        self.first as usize..self.last as usize
    }
}

/// The names of table 2 of ISO 3592; `None` for a type that is not there.
pub fn type_name(kind: u16) -> Option<&'static str> {
    Some(match kind {
        1000 => "original program sequence identification",
        2000 => "integer code type post processor command",
        3000 => "surface data",
        4000 => "relative tool position",
        5000 => "tool position",
        6000 => "post processor information",
        7000 => "starting information",
        8000 => "relative tool direction",
        9000 => "post processor parameters",
        14000 => "part program termination",
        15000 => "unsegmented tool path",
        16000 => "workpiece contour description",
        20000 => "literal type post processor command",
        21000 => "deferred processing command",
        28000..=32000 => "proprietary record",
        _ => return None,
    })
}

/// What a departure from clause 5 is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Slip {
    /// A remark of APT, from `$$` to the line end.
    Remark,
    /// `$`, by which a statement of APT goes on in the next line.
    Continuation,
    /// `/` behind a word, as in a statement of APT.
    Slash,
    /// So many characters in a row that have no meaning outside of literals.
    Meaningless,
    /// So many characters that are not of ISO/IEC 646; within a literal or outside of one.
    Beyond { count: usize, literal: bool },
    /// A keyword with small letters.
    LowerCase,
    /// A literal that is never closed; where it was taken to end.
    Unclosed,
    /// A literal that goes over a line end; the width of that line.
    LineEnd { width: usize },
    /// Nothing between two separators.
    Empty,
    /// No element at all.
    Unreadable(Unreadable),
    /// A keyword that is not among the known words.
    UnknownWord,
    /// A number that cannot be held.
    TooLarge,
    /// A record that ends without its separator; the comma that stands there instead.
    NoSemicolon { comma: Option<usize> },
    /// A file that ends without its separator.
    NoColon,
    /// A separator with no record, or no file, before it.
    Idle,
}

/// Why an element cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unreadable {
    /// An exponent behind a number without a point; where the point belongs.
    NoPoint(usize),
    /// A number that has a second point, a sign inside, or an exponent without digits.
    Number,
    /// A letter alone.
    OneLetter,
    /// A keyword with a digit.
    DigitInWord,
    /// Something beside a literal.
    BesideLiteral,
    /// Characters that are none of the language.
    Foreign,
}

/// A departure and its place, in bytes of the stream; the record in which it stands, by number.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slipped {
    pub slip: Slip,
    pub range: Range<usize>,
    pub record: usize,
}

/// A typographic character, and what it was.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Typographic {
    pub range: Range<usize>,
    pub plain: char,
}

/// All that reading makes of a text: flat tables, in the order of the text.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tables {
    pub elements: Vec<Element>,
    pub records: Vec<Record>,
    /// Where the records of each file end, and where its separator is.
    pub files: Vec<(usize, Option<usize>)>,
    pub slips: Vec<Slipped>,
    pub typographic: Vec<Typographic>,
}

impl Tables {
    pub(crate) fn of(&self, record: &Record) -> &[Element] {
        &self.elements[record.elements()]
    }

    /// The records of each file.
    pub(crate) fn file_records(&self) -> impl Iterator<Item = Range<usize>> {
        let starts = std::iter::once(0).chain(self.files.iter().map(|file| file.0));
        starts.zip(&self.files).map(|(from, file)| from..file.0)
    }
}
