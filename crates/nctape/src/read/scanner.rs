//! From the characters of one block to its words.

use super::number::{Number, NumberFault};
use super::word::Word;
use crate::format::{Control, Sign, System, Zeros};
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
    /// Blank tape, backspace or delete: it is punched, and a control disregards it.
    Disregarded(char),
    /// The code lacks it; it stands in a comment.
    InComment(char),
    /// `)` without `(`.
    ControlIn,
    /// What stands before such a `)` and reads like a comment that lost its `(`.
    LostComment,
    /// Letters for people before the first end of block of the tape, which a control passes over.
    Label,
    /// The same between the program start and the end of block behind it.
    LabelBehindStart,
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
    /// A tab between an address and its digits, which are read as one word.
    TabBehindAddress,
    /// A letter in a number for the digit that it looks like: O, I or L.
    LetterForDigit(char),
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
    /// Its comment is not closed.
    pub unclosed: bool,
    /// There is a tab in it, outside comments.
    pub tab: bool,
    /// How many rows it has on the tape.
    pub rows: usize,
}

/// Reads the block that starts at byte `start`, adding to `words` and `strays`.
pub(crate) fn scan(
    text: &str,
    start: usize,
    control: &Control,
    words: &mut Vec<Word>,
    strays: &mut Vec<Stray>,
) -> Scanned {
    let (first_word, strays_before) = (words.len(), strays.len());
    let mut scanner = Scanner {
        control,
        start,
        words,
        strays,
        word: None,
        tabs: 0,
        tab: 0,
        number_column: 0,
        column: 0,
        skip: None,
        since: start,
        strays_since: strays_before,
        counted: (first_word, 0),
        comment: None,
        any_comment: false,
        any_word: false,
        any_tab: false,
        first_word,
    };
    let mut rows = 0;
    let mut listing = Listing::resume(text, start, false);
    let mut next = text.len();
    let mut end = BlockEnd::Text;
    while let Some(character) = listing.next() {
        match character.mark {
            Mark::EndOfBlock if !character.comment => {
                end = BlockEnd::EndOfBlock(character.from);
                next = character.to;
                rows += 1;
                break;
            }
            Mark::EndOfBlock => rows += 1,
            Mark::Character('%') if !character.comment && !scanner.any_word => {
                end = BlockEnd::ProgramStart;
                next = character.from;
                break;
            }
            Mark::Character(c) => {
                let punched = control.code.row(c).is_some();
                rows += usize::from(punched);
                if character.comment {
                    scanner.take_comment(c, punched, character.from, character.to);
                } else {
                    scanner.take(c, character.from, character.to);
                    // Digits stand together, mostly. Both codes have rows for them.
                    if let Some(word) = scanner.word.as_mut().filter(|_| c != '(') {
                        let digits = listing.digits();
                        rows += digits.len();
                        if !digits.is_empty() {
                            digits.iter().for_each(|digit| word.number.push_digit(digit - b'0'));
                            word.to = character.to + digits.len();
                        }
                    }
                }
            }
        }
    }
    scanner.finish_word();
    let unclosed = scanner.comment.is_some();
    if let Some(from) = scanner.comment {
        scanner.stray(StrayKind::Unclosed, from, from + 1);
    }
    Scanned {
        end,
        next,
        skip: scanner.skip.map(|at| at - start),
        comment: scanner.any_comment,
        unclosed,
        tab: scanner.any_tab,
        rows,
    }
}

struct Scanner<'a> {
    control: &'a Control,
    start: usize,
    words: &'a mut Vec<Word>,
    strays: &'a mut Vec<Stray>,
    word: Option<Open>,
    /// Tabs since the last word.
    tabs: u16,
    /// The last tab.
    tab: usize,
    /// The column of the last number.
    number_column: usize,
    /// Tabs since the start of the block.
    column: usize,
    skip: Option<usize>,
    /// Where the last comment ended; the start of the block where there was none.
    since: usize,
    /// How many strays had been found then.
    strays_since: usize,
    /// So many words, those of earlier blocks among them, have been counted, and so many tabs of this block before them.
    counted: (usize, usize),
    /// The `(` of the open comment.
    comment: Option<usize>,
    any_comment: bool,
    any_word: bool,
    any_tab: bool,
    /// The words of earlier blocks.
    first_word: usize,
}

/// The word being read.
struct Open {
    address: u8,
    lower_case: bool,
    by_column: bool,
    /// It follows another number without a tab: see `split_columns`.
    split: bool,
    tabs: u16,
    number: Number,
    from: usize,
    to: usize,
}

impl Scanner<'_> {
    /// Takes a character that stands in no comment.
    fn take(&mut self, character: char, from: usize, to: usize) {
        match character {
            '(' => {
                self.comment = Some(from);
                self.any_comment = true;
            }
            ')' if self.comment.take().is_some() => (self.since, self.strays_since) = (to, self.strays.len()),
            ')' => {
                self.give_up_comment(from);
                self.stray(StrayKind::ControlIn, from, to);
                (self.since, self.strays_since) = (to, self.strays.len());
            }
            '0'..='9' => {
                let word = self.open(from);
                word.number.push_digit(character as u8 - b'0');
                word.to = to;
            }
            'A'..='Z' | 'a'..='z' | ':' => {
                self.finish_word();
                // RS-244 has no row for it.
                if character == ':' && self.control.code.row(':').is_none() {
                    self.stray(StrayKind::Foreign(':'), from, to);
                }
                self.start_word(character.to_ascii_uppercase() as u8, from, to);
                if let Some(word) = &mut self.word {
                    word.lower_case = character.is_ascii_lowercase();
                }
            }
            '+' | '-' => {
                self.split_columns(from);
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
                self.tab = from;
                self.any_tab = true;
                self.column += 1;
            }
            '/' if !self.any_word && self.skip.is_none() => self.skip = Some(from),
            '/' => self.stray(StrayKind::Skip, from, to),
            '%' => self.stray(StrayKind::ProgramStart, from, to),
            // Blank tape, backspace and delete are in the code and mean nothing: the word goes on behind them.
            '\0' | '\u{8}' | '\u{7F}' => self.stray(StrayKind::Disregarded(character), from, to),
            _ => {
                self.stray(StrayKind::Foreign(character), from, to);
                if let Some(word) = &mut self.word {
                    word.number.fail(NumberFault::Foreign);
                }
            }
        }
    }

    fn take_comment(&mut self, character: char, punched: bool, from: usize, to: usize) {
        match character {
            '(' => self.stray(StrayKind::NestedControlOut, from, to),
            ':' | '%' => self.stray(StrayKind::Reserved(character), from, to),
            _ if !punched => self.stray(StrayKind::InComment(character), from, to),
            _ => {}
        }
    }

    /// Takes words back that stand before a `)` without its `(` and read like a comment: from the first one on that is
    /// no word at all, if most are none. Sound words stay: there the `)` itself is what is too much.
    fn give_up_comment(&mut self, control_in: usize) {
        self.finish_word();
        let since = (self.since - self.start) as u32;
        let tabs = self.control.system == System::Tab;
        let bare = |word: &Word| match word.address {
            0 => !tabs,
            _ => word.fault == NumberFault::Empty && !word.by_column,
        };
        let first = self.first_word + self.own_words().partition_point(|word| word.from < since);
        let lost = self.words[first..].iter().position(&bare);
        let Some(lost) = lost.map(|lost| first + lost) else { return };
        let words = &self.words[lost..];
        if 2 * words.iter().filter(|word| bare(word)).count() <= words.len() {
            return;
        }
        let from = words[0].from;
        self.words.truncate(lost);
        // Those found before `since` stand before it.
        let late = self.strays.split_off(self.strays_since.min(self.strays.len()));
        self.strays.extend(late.into_iter().filter_map(|mut stray| {
            if stray.from >= from {
                let StrayKind::Foreign(character) = stray.kind else { return None };
                stray.kind = StrayKind::InComment(character);
                self.control.code.row(character).is_none().then_some(stray)
            } else {
                Some(stray)
            }
        }));
        self.any_word = self.words.len() > self.first_word;
        self.tabs = 0;
        let (counted, tabs) = std::mem::take(&mut self.counted);
        // A word may have been taken up again and lost since it was counted.
        let (counted, tabs) = if counted <= lost { (counted.max(self.first_word), tabs) } else { (self.first_word, 0) };
        self.column = tabs + self.words[counted..].iter().map(|word| usize::from(word.tabs)).sum::<usize>();
        self.counted = (self.words.len(), self.column);
        self.stray(StrayKind::LostComment, self.start + from as usize, control_in);
    }

    /// The word being read; where there is none, one without an address begins, or with the address of the tab
    /// column in a T system.
    fn open(&mut self, from: usize) -> &mut Open {
        if self.word.is_none() && !self.resume() {
            let by_column = self.control.system == System::Tab;
            let column = self.control.detail.words.get(self.column).filter(|_| by_column);
            self.start_word(column.map_or(0, |word| word.address as u8), from, from);
            if let Some(word) = &mut self.word {
                word.by_column = column.is_some();
                self.number_column = self.column;
            }
        }
        let Some(word) = &mut self.word else { unreachable!("a word was just begun") };
        word
    }

    /// Takes up the word before one tab, where it is an address without digits in a system with addresses: the tab
    /// slipped behind the address.
    fn resume(&mut self) -> bool {
        let Some(last) = self.own_words().last().copied().filter(|_| self.tabs == 1) else { return false };
        let tab = self.start + last.to as usize;
        let bare = last.fault == NumberFault::Empty && last.sign.is_none() && last.address != 0;
        if !bare || self.control.system == System::Tab || self.tab != tab {
            return false;
        }
        self.word = Some(Open {
            address: last.address,
            lower_case: last.lower_case,
            by_column: false,
            split: false,
            tabs: last.tabs,
            number: Number::EMPTY,
            from: self.start + last.from as usize,
            to: tab,
        });
        self.words.pop();
        self.tabs = 0;
        self.column -= 1;
        self.stray(StrayKind::TabBehindAddress, tab, tab + 1);
        true
    }

    /// A sign behind all the digits of a column begins the number of the next one, which lost its tab.
    fn split_columns(&mut self, from: usize) {
        let words = &self.control.detail.words;
        let whole = |open: &Open| {
            let (number, column) = (&open.number, words.get(self.number_column));
            let whole = column.is_some_and(|column| column.fits(number.sign, number.digits));
            open.by_column && number.digits > 0 && number.fault == NumberFault::None && whole
        };
        if !self.word.as_ref().is_some_and(whole) {
            return;
        }
        let next = words.get(self.column + 1).filter(|next| next.dimension && next.sign != Sign::Positive);
        let Some(address) = next.map(|next| next.address as u8) else { return };
        self.finish_word();
        self.start_word(address, from, from);
        if let Some(word) = &mut self.word {
            (word.by_column, word.split) = (true, true);
        }
        self.column += 1;
        self.number_column = self.column;
    }

    /// The words of this block so far.
    fn own_words(&self) -> &[Word] {
        &self.words[self.first_word..]
    }

    fn start_word(&mut self, address: u8, from: usize, to: usize) {
        let tabs = std::mem::take(&mut self.tabs);
        self.any_word = true;
        let number = Number::EMPTY;
        self.word = Some(Open { address, lower_case: false, by_column: false, split: false, tabs, number, from, to });
    }

    fn finish_word(&mut self) {
        let Some(mut open) = self.word.take() else { return };
        let mut number = open.number;
        if number.digits == 0 {
            number.fail(NumberFault::Empty);
        }
        if self.join_letter(&open) {
            return;
        }
        if self.is_sequence_behind_tab(&open) {
            open.address = b'N';
            (self.column, self.number_column) = (0, 0);
        }
        let designation = self.control.designation(open.address);
        // Without addresses a number of zeros alone is one zero at least (3.3.1).
        let zero = open.by_column && number.is_zero_of(designation);
        if open.split {
            let fits = designation.is_some_and(|column| column.fits(number.sign, number.digits));
            let offset = (open.from - self.start) as u32;
            number.fail(if fits { NumberFault::Column } else { NumberFault::SignInside(offset) });
        } else if open.by_column && !zero && number.fault == NumberFault::None && self.strays_column(&number, open.tabs)
        {
            number.fail(NumberFault::Column);
        }
        self.words.push(Word {
            address: open.address,
            lower_case: open.lower_case,
            by_column: open.by_column,
            tabs: open.tabs,
            sign: number.sign,
            digits: number.digits,
            fault: number.fault,
            value: if zero { Some(0) } else { number.value(designation) },
            from: (open.from - self.start) as u32,
            to: (open.to - self.start) as u32,
        });
    }

    /// The first number of a block behind a tab, in a T system, that has the digits of a sequence number and not those of
    /// its column.
    fn is_sequence_behind_tab(&self, open: &Open) -> bool {
        let words = &self.control.detail.words;
        let first = open.by_column && open.tabs > 0 && self.words.len() == self.first_word;
        let fits =
            |column: usize| words.get(column).is_some_and(|word| word.fits(open.number.sign, open.number.digits));
        let headed = words.first().is_some_and(|word| word.address == 'N');
        first && headed && open.number.fault == NumberFault::None && fits(0) && !fits(self.number_column)
    }

    /// A number whose digits do not fit its column, but those of the column beside it: a tab too few before it, or one
    /// too many.
    fn strays_column(&self, number: &Number, tabs: u16) -> bool {
        let words = &self.control.detail.words;
        let fits = |column: Option<usize>| {
            column.and_then(|column| words.get(column)).is_some_and(|word| word.fits(number.sign, number.digits))
        };
        let column = Some(self.number_column);
        let before = self.number_column.checked_sub(1).filter(|_| tabs > 1);
        !fits(column) && (fits(column.map(|column| column + 1)) || fits(before))
    }

    /// Joins an O, I or L to the word right before it, where that lacks just the digit that the letter looks like.
    fn join_letter(&mut self, open: &Open) -> bool {
        let letter = open.address;
        let control = self.control;
        let from = (open.from - self.start) as u32;
        let meant = matches!(letter, b'O' | b'I' | b'L') && open.number.sign.is_none() && open.tabs == 0;
        let Some(last) = self.words[self.first_word..].last_mut().filter(|last| meant && last.to == from) else {
            return false;
        };
        let Some(designation) = control.designation(last.address).filter(|_| !last.by_column) else { return false };
        let digits = last.digits + 1 + open.number.digits;
        let width = u16::from(designation.width());
        let own = control.designation(letter);
        // An address that the format has is the letter meant, unless the word before it is short of just these digits
        // and its own number is too short.
        let fits = match own {
            Some(own) => digits == width && open.number.digits < u16::from(own.width()) && own.zeros == Zeros::All,
            None => digits <= width && !crate::rules::is_declared_letter(char::from(letter), control),
        };
        if !fits || !matches!(last.fault, NumberFault::None | NumberFault::Empty | NumberFault::Foreign) {
            return false;
        }
        last.to = (open.to - self.start) as u32;
        last.digits = digits;
        last.fault = NumberFault::Foreign;
        last.value = None;
        let character = if open.lower_case { letter.to_ascii_lowercase() } else { letter };
        self.stray(StrayKind::LetterForDigit(char::from(character)), open.from, open.from + 1);
        true
    }

    fn stray(&mut self, kind: StrayKind, from: usize, to: usize) {
        self.strays.push(Stray { kind, from: (from - self.start) as u32, to: (to - self.start) as u32 });
    }
}
