//! Elements that are not read at a glance: with layout inside, over line ends, or with something wrong in them.

use super::characters::{is_layout, is_quote, plain};
use super::element::ElementKind;
use super::number;
use super::reader::{End, Reader};
use super::record::{Slip, Slipped, Unreadable};
use super::words::Key;
use std::ops::Range;

/// What was found of an element so far.
#[derive(Default)]
struct Found {
    /// From its first character that has a meaning to behind its last.
    range: Option<Range<usize>>,
    /// There is a literal.
    literal: bool,
    /// There is something beside the literal, or something that is not of the language.
    fault: Option<Unreadable>,
}

impl Found {
    fn take(&mut self, range: Range<usize>) {
        let from = self.range.as_ref().map_or(range.start, |found| found.start);
        self.range = Some(from..range.end);
    }
}

impl Reader<'_> {
    /// Reads an element character by character.
    pub(super) fn any_element(&mut self) -> End {
        self.scratch.clear();
        let start = self.at;
        let mut found = Found::default();
        let end = loop {
            let from = self.at;
            let Some(character) = self.character(from) else {
                self.note_missing_semicolon(&found, from);
                break End::Without;
            };
            let to = from + character.len_utf8();
            match character {
                ',' | ';' => {
                    self.at = to;
                    break if character == ',' { End::Comma } else { End::Semicolon };
                }
                ':' => {
                    self.note_missing_semicolon(&found, from);
                    break End::Without;
                }
                '$' => self.apt_sign(from),
                '/' if found.fault.is_none() && !found.literal && is_word(&self.scratch) => {
                    self.note(Slip::Slash, from..to);
                    self.at = to;
                    break End::Comma;
                }
                _ if character.is_ascii() && is_layout(character as u8) || plain(character) == Some(' ') => {
                    self.skip_layout();
                    if found.range.is_some() && self.breaks_off(from, self.at) {
                        self.note_missing_semicolon(&found, from);
                        break End::Without;
                    }
                    // In columns, a line may begin with the record itself.
                }
                _ if is_quote(character) => self.quote(character, &mut found),
                _ => {
                    if self.stream.is_of_columns() && found.range.is_some() && self.begins_line_of_record(from) {
                        self.note_missing_semicolon(&found, from);
                        break End::Without;
                    }
                    self.plain_character(character, from..to, &mut found);
                }
            }
        };
        self.classify(found, start);
        end
    }

    /// In columns: a line begins right here, and the next record with it.
    fn begins_line_of_record(&self, at: usize) -> bool {
        at > 0 && self.stream.line_begins_in(at - 1..at) && self.begins_next_record(at)
    }

    fn note_missing_semicolon(&mut self, found: &Found, at: usize) {
        // Where there was nothing but a remark there is no record.
        if found.range.is_none() && self.tables.elements.len() == self.first {
            return;
        }
        let end = found.range.as_ref().map_or(at, |range| range.end);
        let comma = if found.range.is_none() { end.checked_sub(1).filter(|at| self.bytes[*at] == b',') } else { None };
        let from = self.stream.text[..end].char_indices().next_back().map_or(0, |(at, _)| at);
        self.note(Slip::NoSemicolon { comma }, from..end);
    }

    /// `$$` and all up to the line end, or `$`.
    fn apt_sign(&mut self, from: usize) {
        let to = if self.bytes.get(from + 1) == Some(&b'$') {
            let next = self.stream.next_line(from).unwrap_or(self.bytes.len());
            let line = self.stream.text[from..next].trim_end();
            self.note(Slip::Remark, from..from + line.len());
            from + line.len()
        } else {
            self.note(Slip::Continuation, from..from + 1);
            from + 1
        };
        self.at = to;
    }

    fn quote(&mut self, quote: char, found: &mut Found) {
        let from = self.at;
        let to = self.literal(quote);
        if found.literal || !self.scratch.is_empty() {
            found.fault = Some(Unreadable::BesideLiteral);
        }
        found.literal = true;
        found.take(from..to);
        self.at = to;
    }

    fn plain_character(&mut self, character: char, range: Range<usize>, found: &mut Found) {
        self.at = range.end;
        match plain(character) {
            Some(sign) => {
                self.note_typographic(range.clone(), sign);
                self.scratch.push(sign);
            }
            None if character.is_ascii_alphanumeric() || matches!(character, '+' | '-' | '.') => {
                self.scratch.push(character);
            }
            None if character.is_ascii() => {
                self.meaningless(range);
                return;
            }
            None => {
                found.fault = found.fault.or(Some(Unreadable::Foreign));
                self.beyond(range.clone());
            }
        }
        if found.literal {
            found.fault = Some(Unreadable::BesideLiteral);
        }
        found.take(range);
    }

    /// A character that has no meaning (5.5.3); those in a row are said at once.
    fn meaningless(&mut self, range: Range<usize>) {
        match self.tables.slips.last_mut() {
            Some(last) if last.slip == Slip::Meaningless && last.range.end == range.start => last.range.end = range.end,
            _ => self.note(Slip::Meaningless, range),
        }
    }

    /// A character that is not of ISO/IEC 646; those in a row are said at once.
    fn beyond(&mut self, range: Range<usize>) {
        let last = self.tables.slips.last_mut().filter(|last| last.range.end == range.start);
        if let Some(Slipped { slip: Slip::Beyond { count, literal: false }, range: before, .. }) = last {
            *count += 1;
            before.end = range.end;
            return;
        }
        self.note(Slip::Beyond { count: 1, literal: false }, range);
    }

    /// Says what an element is.
    fn classify(&mut self, found: Found, start: usize) {
        let Some(range) = found.range else {
            // Where only a remark or a continuation stands, or the text ends, there may be no element at all.
            let end = self.at.min(self.bytes.len());
            let separator = end.checked_sub(1).filter(|at| *at >= start && matches!(self.bytes[*at], b',' | b';'));
            let place = separator.unwrap_or(start);
            if separator.is_some() {
                self.note(Slip::Empty, place..place + 1);
            }
            self.push(ElementKind::Unreadable, place..place, 0);
            return;
        };
        let fault = match found.fault {
            Some(Unreadable::Foreign) => {
                // The characters themselves are said already.
                return self.push(ElementKind::Unreadable, range, 0);
            }
            Some(fault) => fault,
            None if found.literal => return self.push(ElementKind::Literal, range, 0),
            None => match self.number_or_word(&range) {
                Ok((kind, bits)) => return self.push(kind, range, bits),
                Err(fault) => fault,
            },
        };
        self.note(Slip::Unreadable(fault), range.clone());
        self.push(ElementKind::Unreadable, range, 0);
    }

    /// The number or the word that the characters make.
    fn number_or_word(&mut self, range: &Range<usize>) -> Result<(ElementKind, u64), Unreadable> {
        let text = std::mem::take(&mut self.scratch);
        let result = self.read_scratch(&text, range);
        self.scratch = text;
        result
    }

    fn read_scratch(&mut self, text: &str, range: &Range<usize>) -> Result<(ElementKind, u64), Unreadable> {
        if !text.starts_with(|first: char| first.is_ascii_alphabetic()) {
            return match number::read(text) {
                Some((kind, value)) => {
                    if !value.is_finite() {
                        self.note(Slip::TooLarge, range.clone());
                    }
                    Ok((kind, value.to_bits()))
                }
                None => Err(self.number_fault(text, range)),
            };
        }
        if text.len() < 2 {
            return Err(Unreadable::OneLetter);
        }
        if !text.bytes().all(|byte| byte.is_ascii_alphabetic()) {
            return Err(if text.bytes().all(|byte| byte.is_ascii_alphanumeric()) {
                Unreadable::DigitInWord
            } else {
                Unreadable::Number
            });
        }
        let word = text.to_ascii_uppercase();
        let key = Key::of(&word);
        if !self.knows(key) {
            self.note(Slip::UnknownWord, range.clone());
        }
        if word != text {
            self.note(Slip::LowerCase, range.clone());
        }
        Ok((ElementKind::Keyword, key.0))
    }

    /// Why characters that begin as a number make none.
    fn number_fault(&self, text: &str, range: &Range<usize>) -> Unreadable {
        let Some(at) = text.find(['E', 'e']) else { return Unreadable::Number };
        let mended = format!("{}.{}", &text[..at], &text[at..]);
        let place = self.stream.text[range.clone()].find(['E', 'e']).map(|at| range.start + at);
        match place {
            Some(place) if number::read(&mended).is_some() => Unreadable::NoPoint(place),
            _ => Unreadable::Number,
        }
    }
}

/// Two letters or more, and nothing else.
fn is_word(text: &str) -> bool {
    text.len() >= 2 && text.bytes().all(|byte| byte.is_ascii_alphabetic())
}
