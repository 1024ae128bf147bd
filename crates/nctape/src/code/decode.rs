//! From rows of holes to a listing, and what is wrong with the rows.

use super::label::labels;
use super::{Code, Track8, iso840, recognise, track_8};
use crate::order::order_by_key;
use crate::rules::{Rule, row, tape};
use std::ops::Range;

/// What a tape says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// The listing: capital letters, a line end for each end of block, U+FFFD for a row that cannot be read.
    pub text: String,
    /// The code that it was read in.
    pub code: Code,
    /// Why that code, in words.
    pub reason: String,
    /// Blocks end with carriage returns: no line feed is on the tape.
    pub by_return: bool,
    /// What is wrong with the rows, in their order.
    pub issues: Vec<RowIssue>,
}

/// Something about one row that the listing does not show.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowIssue {
    /// The row, counted from 0.
    pub row: usize,
    /// Its holes.
    pub byte: u8,
    /// What it is.
    pub kind: RowIssueKind,
    /// In words.
    pub message: String,
    /// Its place in the listing, in bytes; empty where it left nothing there.
    pub range: Range<usize>,
}

/// What can be wrong with a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowIssueKind {
    /// The count of holes is odd in ISO code, or even in EIA code.
    Parity,
    /// The parity is right, but the code has no such character.
    Unknown,
    /// No hole at all, between the first and the last end of block.
    Blank,
    /// A delete, backspace or shift: a control disregards it.
    Disregarded,
    /// All eight holes on an EIA tape: the delete of ISO code.
    ForeignDelete,
    /// Track 8 never or always punched on an ISO tape. Said once, at the first row that differs.
    NoParity,
    /// A character that makers added to the code: the standards have it not.
    Extension,
    /// A stretch of rows before the first or behind the last end of block that are no characters: a label that a
    /// person reads, or damage. Said once, at its first row.
    Label,
    /// The tape has no end of block before its first block.
    NoFirstEnd,
    /// The tape does not end with an end of block.
    NoLastEnd,
    /// The characters of a block, end of block included, are odd in number.
    OddBlock,
}

impl RowIssueKind {
    /// Its name in the interface.
    pub fn name(self) -> &'static str {
        match self {
            RowIssueKind::Parity => "parity",
            RowIssueKind::Unknown => "unknown",
            RowIssueKind::Blank => "blank",
            RowIssueKind::Disregarded => "disregarded",
            RowIssueKind::ForeignDelete => "foreign-delete",
            RowIssueKind::NoParity => "no-parity",
            RowIssueKind::Extension => "extension",
            RowIssueKind::Label => "label",
            RowIssueKind::NoFirstEnd => "no-first-end",
            RowIssueKind::NoLastEnd => "no-last-end",
            RowIssueKind::OddBlock => "odd-block",
        }
    }

    /// The rule that it falls under.
    pub fn rule(self) -> &'static Rule {
        match self {
            RowIssueKind::Parity => &row::parity::RULE,
            RowIssueKind::Unknown => &row::unknown::RULE,
            RowIssueKind::Blank => &row::blank::RULE,
            RowIssueKind::Disregarded => &row::disregarded::RULE,
            RowIssueKind::ForeignDelete => &row::foreign_delete::RULE,
            RowIssueKind::NoParity => &row::no_parity::RULE,
            RowIssueKind::OddBlock => &row::odd_block::RULE,
            RowIssueKind::Label => &row::label::RULE,
            RowIssueKind::Extension => &tape::foreign_character::RULE,
            RowIssueKind::NoFirstEnd => &tape::leading_end::RULE,
            RowIssueKind::NoLastEnd => &tape::last_end::RULE,
        }
    }
}

/// How rows are decoded.
#[derive(Clone, Copy, Debug, Default)]
pub struct DecodeOptions {
    /// The code; recognised by itself where it is `None`.
    pub code: Option<Code>,
    /// Counts the characters of each block (TV, the vertical check): a tape punched for it has an even number.
    pub count_blocks: bool,
}

/// What a row is to the reader.
enum Meaning {
    Character(char),
    EndOfBlock,
    Nothing,
    Issue(RowIssueKind, Option<char>),
}

/// Reads rows of holes.
///
/// Between the first and the last end of block every row must be a character of the code; before and behind them are
/// leader, label and trailer, where blank tape and delete are as they should be. A carriage return ends a block on an
/// ISO tape without line feeds; beside line feeds a control disregards it. A tape without any end of block has no place
/// for a label: all its rows are judged. Where track 8 of an ISO tape is never or always punched it is passed over, and
/// that is said once.
///
/// ```
/// use nctape::code::{Code, DecodeOptions, decode};
/// let rows = [0x00, 0x80, 0x45, 0x20, 0x20, 0x01, 0x80, 0x00];
/// let decoded = decode(&rows, DecodeOptions::default());
/// assert_eq!((decoded.code, decoded.text.as_str()), (Code::Eia, "\nN001\n"));
/// assert!(decoded.issues.is_empty());
/// ```
pub fn decode(rows: &[u8], options: DecodeOptions) -> Decoded {
    let (code, reason) = match options.code {
        Some(code) => (code, format!("{} was asked for.", code.name())),
        None => recognise(rows),
    };
    let track_8 = if code == Code::Iso { track_8(rows) } else { Track8::Parity };
    let mended: Vec<u8> = rows.iter().map(|&row| track_8.mended(row)).collect();
    let by_return = code == Code::Iso && !mended.contains(&0x0A) && mended.contains(&0x8D);
    let is_end = |row: u8| match code {
        Code::Eia => row == 0x80,
        Code::Iso => row == if by_return { 0x8D } else { 0x0A },
    };
    let span = |is: &dyn Fn(u8) -> bool| {
        Some((mended.iter().position(|&row| is(row))?, mended.iter().rposition(|&row| is(row))?))
    };
    let is_punched = |row: u8| !matches!(row, 0x00 | 0x7F | 0xFF);
    let significant = match (span(&is_end), span(&is_punched)) {
        (Some((first, last)), _) => first..last,
        (None, Some((first, last))) => first..last + 1,
        (None, None) => 0..0,
    };
    let mut decoded = Decoded { text: String::new(), code, reason, by_return, issues: Vec::new() };
    let mut places: Vec<(usize, char)> = Vec::new();
    let mut label: Option<usize> = None;
    let labels = labels(&mended, code, &significant);
    let mut parity_said = false;
    for (row, (&byte, &read)) in rows.iter().zip(&mended).enumerate() {
        let from = decoded.text.len();
        if let Some(stretch) = labels.iter().find(|stretch| stretch.contains(&row)) {
            if stretch.start == row {
                let kind = RowIssueKind::Label;
                let message = message(kind, byte, code);
                decoded.issues.push(RowIssue { row, byte, kind, message, range: from..from });
            }
            continue;
        }
        let (character, kind) = match meaning(read, code, is_end(read), significant.contains(&row)) {
            Meaning::Nothing => continue,
            Meaning::EndOfBlock => (Some('\n'), None),
            Meaning::Character(character) => (Some(character), None),
            Meaning::Issue(RowIssueKind::Parity | RowIssueKind::Unknown, _) if !significant.contains(&row) => {
                if label.is_none_or(|last| last + 1 != row) {
                    let kind = RowIssueKind::Label;
                    let message = message(kind, byte, code);
                    decoded.issues.push(RowIssue { row, byte, kind, message, range: from..from });
                }
                label = Some(row);
                continue;
            }
            Meaning::Issue(kind, character) => (character, Some(kind)),
        };
        let no_parity = byte != read && kind.is_none() && !parity_said;
        parity_said |= no_parity;
        let kind = kind.or(no_parity.then_some(RowIssueKind::NoParity));
        if let Some(character) = character {
            decoded.text.push(character);
            places.push((row, character));
        }
        if let Some(kind) = kind {
            // A delete without parity is a delete; the holes of the other rows are told as they are.
            let message = message(kind, if kind == RowIssueKind::Disregarded { read } else { byte }, code);
            decoded.issues.push(RowIssue { row, byte, kind, message, range: from..decoded.text.len() });
        }
    }
    check_ends(&mut decoded, rows, &places);
    if options.count_blocks {
        count_blocks(&mut decoded, rows, &mended, &significant, is_end);
    }
    order_by_key(&mut decoded.issues, |issue| (issue.row, 0));
    decoded
}

fn meaning(row: u8, code: Code, end: bool, significant: bool) -> Meaning {
    if end {
        return Meaning::EndOfBlock;
    }
    match (row, code) {
        // Blank tape is harmless in ISO code, an alarm in EIA code between the ends of block.
        (0x00, Code::Eia) if significant => return Meaning::Issue(RowIssueKind::Blank, None),
        (0x00, _) => return Meaning::Nothing,
        (0x7F, Code::Eia) | (0xFF, _) if !significant => return Meaning::Nothing,
        (0xFF, Code::Eia) => return Meaning::Issue(RowIssueKind::ForeignDelete, None),
        _ => {}
    }
    if !code.parity_fits(row) {
        return Meaning::Issue(RowIssueKind::Parity, Some('\u{FFFD}'));
    }
    match code.character(row) {
        Some('\r') => Meaning::Nothing,
        Some('\u{8}' | '\u{7F}') => Meaning::Issue(RowIssueKind::Disregarded, None),
        Some(character) => Meaning::Character(character),
        None if code.meaning(row).is_some() => Meaning::Issue(RowIssueKind::Disregarded, None),
        None => match iso840::extension(row).filter(|_| code == Code::Iso) {
            Some(character) => Meaning::Issue(RowIssueKind::Extension, Some(character)),
            None => Meaning::Issue(RowIssueKind::Unknown, Some('\u{FFFD}')),
        },
    }
}

fn message(kind: RowIssueKind, byte: u8, code: Code) -> String {
    match kind {
        RowIssueKind::Parity => row::parity::message(byte, code),
        RowIssueKind::Unknown => row::unknown::message(byte, code),
        RowIssueKind::Blank => row::blank::message(byte, code),
        RowIssueKind::Disregarded => row::disregarded::message(byte, code),
        RowIssueKind::ForeignDelete => row::foreign_delete::message(byte, code),
        RowIssueKind::NoParity => row::no_parity::message(byte, code),
        RowIssueKind::OddBlock => row::odd_block::message(byte, code),
        RowIssueKind::Label => row::label::message(byte, code),
        RowIssueKind::Extension => format!(
            "The row has {}: a character that makers added; neither ISO 2539 nor RS-358 has it.",
            row::tracks(byte)
        ),
        RowIssueKind::NoFirstEnd => {
            "The tape has no end of block before its first block; a control passes over everything up to the first one."
                .to_owned()
        }
        RowIssueKind::NoLastEnd => "The tape does not end with an end of block.".to_owned(),
    }
}

/// Reports a first or last end of block that is not there.
fn check_ends(decoded: &mut Decoded, rows: &[u8], places: &[(usize, char)]) {
    let mut comment = false;
    // A comment is no part of the program: it may stand before the first end of block and behind the last.
    let program: Vec<(usize, usize, char)> = places
        .iter()
        .scan(0, |at, &(row, character)| {
            let from = *at;
            *at += character.len_utf8();
            Some((row, from, character))
        })
        .filter(|&(_, _, character)| {
            let inside = comment || character == '(';
            comment = match character {
                '(' => true,
                ')' => false,
                _ => comment,
            };
            !inside && character != ' '
        })
        .collect();
    let mut head = program.iter().skip_while(|(_, _, character)| *character == '%' || character.is_ascii_digit());
    let has_words = program.iter().any(|(_, _, character)| !matches!(character, '\n' | '%'));
    let mut report = |kind: RowIssueKind, &(row, from, character): &(usize, usize, char)| {
        let message = message(kind, rows[row], decoded.code);
        let range = from..from + character.len_utf8();
        decoded.issues.push(RowIssue { row, byte: rows[row], kind, message, range });
    };
    if let Some(first) = head.next().filter(|(_, _, character)| has_words && *character != '\n') {
        report(RowIssueKind::NoFirstEnd, first);
    }
    let last = program.iter().rev().find(|(_, _, character)| *character != '%');
    if let Some(last) = last.filter(|(_, _, character)| has_words && *character != '\n') {
        report(RowIssueKind::NoLastEnd, last);
    }
}

/// Reports each block whose characters are odd in number.
fn count_blocks(
    decoded: &mut Decoded,
    rows: &[u8],
    mended: &[u8],
    significant: &Range<usize>,
    is_end: impl Fn(u8) -> bool,
) {
    let mut count = 0;
    let mut line_ends = decoded.text.match_indices('\n').map(|(at, _)| at).skip(1).collect::<Vec<_>>().into_iter();
    // The first end of block ends no block; blank rows are no characters.
    for (row, &byte) in mended.iter().enumerate().take(significant.end + 1).skip(significant.start + 1) {
        count += usize::from(byte != 0);
        if is_end(byte) {
            let byte = rows[row];
            let at = line_ends.next().unwrap_or(decoded.text.len());
            if count % 2 == 1 {
                let kind = RowIssueKind::OddBlock;
                let range = at..(at + 1).min(decoded.text.len());
                decoded.issues.push(RowIssue { row, byte, kind, message: message(kind, byte, decoded.code), range });
            }
            count = 0;
        }
    }
}
