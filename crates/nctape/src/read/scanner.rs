//! From the characters of one block to its words.

use super::number::{Number, NumberFault};
use super::word::Word;
use crate::format::{Control, System};
use crate::text::{Listing, Mark};

/// A character that belongs to no word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stray {
    pub kind: StrayKind,
    /// Bytes from the start of the block.
    pub from: u32,
    pub to: u32,
}

impl Stray {
    pub(crate) fn range(&self) -> std::ops::Range<usize> {
        self.from as usize..self.to as usize
    }
}

/// Why a character belongs to no word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StrayKind {
    /// It is no character of the tape's format.
    Foreign(char),
    /// The code lacks it; it stands in a comment.
    InComment(char),
    /// `)` without `(`.
    ControlIn,
    /// `(` in a comment.
    NestedControlOut,
    /// `:` or `%` in a comment.
    Reserved(char),
    /// `(` that nothing closes.
    Unclosed,
    /// `/` that is not at the head of the block.
    Skip,
    /// `%` behind the first word of a block.
    ProgramStart,
}

impl StrayKind {
    /// It stands in a comment, or would end one.
    pub(crate) fn is_in_comment(self) -> bool {
        matches!(self, StrayKind::InComment(_) | StrayKind::NestedControlOut | StrayKind::Reserved(_))
    }
}

/// How a block ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BlockEnd {
    /// With the end-of-block character that starts at this byte of the text.
    EndOfBlock(usize),
    /// With a program start character, which belongs to no block, before any word.
    ProgramStart,
    /// With the text.
    Text,
}

/// What was read of one block besides its words.
pub(crate) struct Scanned {
    pub end: BlockEnd,
    /// The byte of the text where the next block starts.
    pub next: usize,
    /// Offset of the `/` at the head of the block.
    pub skip: Option<usize>,
    /// There is a comment in it.
    pub comment: bool,
}

/// Reads the block that starts at byte `start`, adding to `words` and `strays`.
pub(crate) fn scan(
    text: &str,
    start: usize,
    control: &Control,
    words: &mut Vec<Word>,
    strays: &mut Vec<Stray>,
) -> Scanned {
    let mut scanner = Scanner {
        control,
        start,
        words,
        strays,
        word: None,
        tabs: 0,
        column: 0,
        skip: None,
        comment: None,
        any_comment: false,
        any_word: false,
    };
    let mut listing = Listing::resume(text, start, false);
    let mut next = text.len();
    let mut end = BlockEnd::Text;
    for character in &mut listing {
        match character.mark {
            Mark::EndOfBlock if !character.comment => {
                end = BlockEnd::EndOfBlock(character.from);
                next = character.to;
                break;
            }
            Mark::EndOfBlock => {}
            Mark::Character('%') if !character.comment && !scanner.any_word => {
                end = BlockEnd::ProgramStart;
                next = character.from;
                break;
            }
            Mark::Character(c) => scanner.take(c, character.from, character.to, character.comment),
        }
    }
    scanner.finish_word();
    if let Some(from) = scanner.comment {
        scanner.stray(StrayKind::Unclosed, from, from + 1);
    }
    Scanned { end, next, skip: scanner.skip.map(|at| at - start), comment: scanner.any_comment }
}

struct Scanner<'a> {
    control: &'a Control,
    start: usize,
    words: &'a mut Vec<Word>,
    strays: &'a mut Vec<Stray>,
    word: Option<Open>,
    /// Tabs since the last word.
    tabs: u16,
    /// Tabs since the start of the block.
    column: usize,
    skip: Option<usize>,
    /// The `(` of the open comment.
    comment: Option<usize>,
    any_comment: bool,
    any_word: bool,
}

/// The word being read.
struct Open {
    address: u8,
    lower_case: bool,
    by_column: bool,
    tabs: u16,
    number: Number,
    from: usize,
    to: usize,
}

impl Scanner<'_> {
    fn take(&mut self, character: char, from: usize, to: usize, comment: bool) {
        match character {
            '(' if comment => self.stray(StrayKind::NestedControlOut, from, to),
            '(' => {
                self.comment = Some(from);
                self.any_comment = true;
            }
            ')' if self.comment.take().is_some() => {}
            ')' => self.stray(StrayKind::ControlIn, from, to),
            _ if comment => self.take_comment(character, from, to),
            '0'..='9' => {
                let word = self.open(from);
                word.number.push_digit(character as u8 - b'0');
                word.to = to;
            }
            'A'..='Z' | 'a'..='z' | ':' => {
                self.finish_word();
                self.start_word(character.to_ascii_uppercase() as u8, from, to);
                if let Some(word) = &mut self.word {
                    word.lower_case = character.is_ascii_lowercase();
                }
            }
            '+' | '-' => {
                let offset = (from - self.start) as u32;
                let word = self.open(from);
                word.number.push_sign(character as u8, offset);
                word.to = to;
            }
            '.' | ',' if self.word.is_some() => {
                let offset = (from - self.start) as u32;
                let word = self.open(from);
                word.number.fail(NumberFault::DecimalSign(offset));
                word.to = to;
            }
            '\t' => {
                self.finish_word();
                self.tabs = self.tabs.saturating_add(1);
                self.column += 1;
            }
            '/' if !self.any_word && self.skip.is_none() => self.skip = Some(from),
            '/' => self.stray(StrayKind::Skip, from, to),
            '%' => self.stray(StrayKind::ProgramStart, from, to),
            _ => {
                self.stray(StrayKind::Foreign(character), from, to);
                if let Some(word) = &mut self.word {
                    word.number.fail(NumberFault::Foreign);
                }
            }
        }
    }

    fn take_comment(&mut self, character: char, from: usize, to: usize) {
        if matches!(character, ':' | '%') {
            self.stray(StrayKind::Reserved(character), from, to);
        } else if self.control.code.row(character).is_none() {
            self.stray(StrayKind::InComment(character), from, to);
        }
    }

    /// The word being read; where there is none, one without an address begins, or with the address of the tab
    /// column in a T system.
    fn open(&mut self, from: usize) -> &mut Open {
        if self.word.is_none() {
            let by_column = self.control.system == System::Tab;
            let column = self.control.detail.words.get(self.column).filter(|_| by_column);
            self.start_word(column.map_or(0, |word| word.address as u8), from, from);
            if let Some(word) = &mut self.word {
                word.by_column = column.is_some();
            }
        }
        let Some(word) = &mut self.word else { unreachable!("a word was just begun") };
        word
    }

    fn start_word(&mut self, address: u8, from: usize, to: usize) {
        let tabs = std::mem::take(&mut self.tabs);
        self.any_word = true;
        self.word = Some(Open { address, lower_case: false, by_column: false, tabs, number: Number::EMPTY, from, to });
    }

    fn finish_word(&mut self) {
        let Some(open) = self.word.take() else { return };
        let mut number = open.number;
        if number.digits == 0 {
            number.fail(NumberFault::Empty);
        }
        self.words.push(Word {
            address: open.address,
            lower_case: open.lower_case,
            by_column: open.by_column,
            tabs: open.tabs,
            sign: number.sign,
            digits: number.digits,
            fault: number.fault,
            value: number.value(self.control.designation(open.address)),
            from: (open.from - self.start) as u32,
            to: (open.to - self.start) as u32,
        });
    }

    fn stray(&mut self, kind: StrayKind, from: usize, to: usize) {
        self.strays.push(Stray { kind, from: (from - self.start) as u32, to: (to - self.start) as u32 });
    }
}
