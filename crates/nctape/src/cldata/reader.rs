//! From a text to elements, records and files (clause 5). It never fails: what is not of the language is noted, and
//! reading goes on where the next thing begins.

use super::characters::{is_layout, plain};
use super::element::{Element, ElementKind};
use super::record::{Record, Slip, Slipped, Tables, Typographic, type_name};
use super::stream::Stream;
use super::words::{Key, Vocabulary};
use std::ops::Range;

pub(super) struct Reader<'a> {
    pub(super) stream: &'a Stream<'a>,
    pub(super) bytes: &'a [u8],
    pub(super) at: usize,
    pub(super) tables: Tables,
    vocabulary: Vocabulary,
    /// The elements of the record in hand begin here.
    pub(super) first: usize,
    /// The number of the record in hand.
    number: Option<i64>,
    /// What an element is made of that is not read at a glance, without what has no meaning.
    pub(super) scratch: String,
}

/// What ends an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// A comma: another element follows.
    Comma,
    /// The record separator.
    Semicolon,
    /// The file separator, the end of the text, or the start of the next record; it is still to be read.
    Without,
}

/// Reads a text.
pub(super) fn read(stream: &Stream<'_>) -> Tables {
    let bytes = stream.text.as_bytes();
    let mut tables = Tables::default();
    // Typical records have 30 bytes and six elements.
    tables.records.reserve(bytes.len() / 30 + 1);
    tables.elements.reserve(bytes.len() / 5 + 1);
    let vocabulary = Vocabulary::new();
    let mut reader =
        Reader { stream, bytes, at: 0, tables, vocabulary, first: 0, number: None, scratch: String::new() };
    reader.read();
    reader.tables
}

impl Reader<'_> {
    fn read(&mut self) {
        loop {
            self.skip_layout();
            match self.bytes.get(self.at) {
                None => break,
                Some(b';') => {
                    self.note(Slip::Idle, self.at..self.at + 1);
                    self.at += 1;
                }
                Some(b':') => {
                    if self.file_start() == self.tables.records.len() {
                        self.note(Slip::Idle, self.at..self.at + 1);
                    } else {
                        self.end_file(Some(self.at));
                    }
                    self.at += 1;
                }
                Some(_) => self.record(),
            }
        }
        if self.file_start() < self.tables.records.len() {
            self.note_missing_colon();
        }
    }

    /// Where the records of the file in hand begin.
    fn file_start(&self) -> usize {
        self.tables.files.last().map_or(0, |file| file.0)
    }

    fn end_file(&mut self, separator: Option<usize>) {
        self.tables.files.push((self.tables.records.len(), separator));
    }

    fn note_missing_colon(&mut self) {
        let end = self.tables.records.last().map_or(0, |record| record.to as usize);
        let last = self.stream.text[..end].char_indices().next_back().map_or(0, |(at, _)| at);
        self.note(Slip::NoColon, last..end);
        self.end_file(None);
    }

    pub(super) fn note(&mut self, slip: Slip, range: Range<usize>) {
        let record = self.tables.records.len();
        self.tables.slips.push(Slipped { slip, range, record });
    }

    pub(super) fn note_typographic(&mut self, range: Range<usize>, plain: char) {
        self.tables.typographic.push(Typographic { range, plain });
    }

    /// The character at a place.
    pub(super) fn character(&self, at: usize) -> Option<char> {
        self.stream.text[at..].chars().next()
    }

    /// Passes over what has no significance.
    pub(super) fn skip_layout(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if is_layout(byte) {
                self.at += 1;
            } else if byte < 128 {
                return;
            } else {
                let Some(character) = self.character(self.at) else { return };
                if plain(character) != Some(' ') {
                    return;
                }
                let range = self.at..self.at + character.len_utf8();
                self.at = range.end;
                self.note_typographic(range, ' ');
            }
        }
    }

    /// Reads a record. It may belong to another file, where the one in hand lacks its separator.
    fn record(&mut self) {
        let start = self.at;
        self.first = self.tables.elements.len();
        self.number = None;
        let end = loop {
            let end = self.element();
            if self.tables.elements.len() == self.first + 1 {
                self.number = self.tables.elements[self.first].whole();
            }
            if end != End::Comma {
                break end;
            }
        };
        let last = self.tables.elements.len();
        let (record, elements) = (self.tables.records.len(), &self.tables.elements[self.first..]);
        let kind = elements.get(1).and_then(Element::whole).and_then(|kind| u16::try_from(kind).ok()).unwrap_or(0);
        // Only a part program termination says that the file is at its end where the separator is missing.
        let begins_another = self.number == Some(1)
            && self.file_start() < record
            && self.tables.records.last().is_some_and(|before| before.kind == 14000);
        if begins_another {
            self.note_missing_colon();
        }
        // What is taken out of a record before its first element is not of it.
        let from = self.tables.elements.get(self.first).map_or(start, |element| element.from as usize);
        let to = match end {
            End::Semicolon => self.at,
            _ => self.tables.elements[self.first..].last().map_or(from, |element| element.to as usize),
        };
        let file = self.tables.files.len() as u32;
        let (first, last) = (self.first as u32, last as u32);
        // A record in which nothing is left, as where all of it is a remark, is none.
        let is_nothing = last == first + 1 && to == from && end == End::Without;
        if is_nothing {
            self.tables.elements.truncate(self.first);
            return;
        }
        self.tables.records.push(Record { kind, file, from: from as u32, to: to as u32, first, last });
    }

    /// Adds an element.
    pub(super) fn push(&mut self, kind: ElementKind, range: Range<usize>, bits: u64) {
        self.tables.elements.push(Element { kind, from: range.start as u32, to: range.end as u32, bits });
    }

    /// Reads an element and what ends it.
    fn element(&mut self) -> End {
        let before = self.at;
        self.skip_layout();
        // Behind the comma of a record that lacks its end.
        if self.first < self.tables.elements.len() && self.breaks_off(before, self.at) {
            let comma = self.bytes[..before].iter().rposition(|byte| *byte == b',');
            self.note(Slip::NoSemicolon { comma }, before.saturating_sub(1)..before);
            return End::Without;
        }
        let from = self.at;
        let end = match self.bytes.get(self.at) {
            Some(b'0'..=b'9' | b'+' | b'-' | b'.') => self.number_at_a_glance(),
            Some(b'A'..=b'Z') => self.word_at_a_glance(),
            Some(b'\'') => self.literal_at_a_glance(),
            _ => None,
        };
        end.unwrap_or_else(|| {
            self.at = from;
            self.any_element()
        })
    }

    /// What ends an element that was read at a glance; `None` where it goes on in another way.
    fn end_at_a_glance(&mut self) -> Option<End> {
        let end = match self.bytes.get(self.at)? {
            b',' => End::Comma,
            b';' => End::Semicolon,
            _ => return None,
        };
        self.at += 1;
        Some(end)
    }

    fn number_at_a_glance(&mut self) -> Option<End> {
        let from = self.at;
        let length =
            self.bytes[from..].iter().take_while(|byte| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'E' | b'e'));
        let to = from + length.count();
        self.at = to;
        let end = self.end_at_a_glance()?;
        let (kind, value) = super::number::read(&self.stream.text[from..to])?;
        if !value.is_finite() {
            return None;
        }
        self.push(kind, from..to, value.to_bits());
        Some(end)
    }

    fn word_at_a_glance(&mut self) -> Option<End> {
        let from = self.at;
        let to = from + self.bytes[from..].iter().take_while(|byte| byte.is_ascii_uppercase()).count();
        let key = Key::of_bytes(&self.bytes[from..to]);
        if to - from < 2 || !self.knows(key) {
            return None;
        }
        self.at = to;
        let end = self.end_at_a_glance()?;
        self.push(ElementKind::Keyword, from..to, key.0);
        Some(end)
    }

    fn literal_at_a_glance(&mut self) -> Option<End> {
        let from = self.at;
        let inside = self.bytes[from + 1..].iter().take_while(|byte| matches!(byte, b' '..=b'~') && **byte != b'\'');
        self.at = from + 1 + inside.count() + 1;
        if self.bytes.get(self.at - 1) != Some(&b'\'') {
            return None;
        }
        let to = self.at;
        if self.stream.is_of_columns() && self.stream.line_begins_in(from..to) {
            return None;
        }
        let end = self.end_at_a_glance()?;
        self.push(ElementKind::Literal, from..to, 0);
        Some(end)
    }

    pub(super) fn knows(&self, key: Key) -> bool {
        self.vocabulary.knows(key)
    }

    /// A line begins between two places, and behind the second one stands what can only be the next record: its number
    /// is the next one, and its type is one of table 2.
    pub(super) fn breaks_off(&self, from: usize, to: usize) -> bool {
        from < to && self.stream.line_begins_in(from..to) && self.begins_next_record(to)
    }

    pub(super) fn begins_next_record(&self, at: usize) -> bool {
        let number = self.number.or_else(|| {
            // Where the first element cannot be read, any record is the next one.
            (self.tables.elements.len() > self.first).then_some(-1)
        });
        let Some((found, at)) = self.small_integer(at) else { return false };
        let at = self.layout_end(at);
        if self.bytes.get(at) != Some(&b',') {
            return false;
        }
        let Some((kind, at)) = self.small_integer(self.layout_end(at + 1)) else { return false };
        let at = self.layout_end(at);
        let ends = matches!(self.bytes.get(at), None | Some(b',' | b';' | b':'));
        let is_type = u16::try_from(kind).is_ok_and(|kind| type_name(kind).is_some());
        let is_terminated =
            self.tables.elements.get(self.first + 1).and_then(Element::whole) == Some(14000) && found == 1;
        ends && is_type && (number.is_some_and(|number| number < 0 || found == number + 1) || is_terminated)
    }

    fn layout_end(&self, at: usize) -> usize {
        at + self.bytes[at..].iter().take_while(|byte| is_layout(**byte)).count()
    }

    /// Digits at a place, few enough for the number of a record, and where they end.
    fn small_integer(&self, at: usize) -> Option<(i64, usize)> {
        let to = at + self.bytes.get(at..)?.iter().take_while(|byte| byte.is_ascii_digit()).count();
        // An f64 holds every number of fifteen digits.
        (to > at && to - at <= 15).then(|| (self.stream.text[at..to].parse().unwrap_or(0), to))
    }
}
