//! How a code says a feed or a spindle speed: the five methods of ISO 2539 annex A, three of which are those of
//! ISO 1058 annex A. Every one is read and written here.
//!
//! | method | a code says | a speed is written as |
//! |---|---|---|
//! | [`reciprocal`] | a rate per minute | the greatest code that is not faster |
//! | [`arithmetic`] | its leading digits | rounded half up |
//! | [`geometric`] | an entry of a table | the entry nearest in ratio |
//! | [`symbolic`] | an entry of the format's own table | the entry nearest in ratio |
//! | [`direct`] | itself | rounded half up |
//!
//! A speed is in the unit that the format counts it in: millimetres or inches per minute or per revolution, or
//! revolutions per minute.

pub mod arithmetic;
mod compare;
mod decimal;
pub mod direct;
pub mod geometric;
pub mod reciprocal;
pub mod symbolic;

pub use compare::{Compared, Comparison};

use crate::format::{Control, FeedCoding, SpindleCoding, Standard};
use std::collections::BTreeMap;
use std::fmt;

/// What a code says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// A speed.
    Is(f64),
    /// Rapid traverse, as fast as the machine moves. ISO 2539 annex A gives it the highest code: 99 of the geometric
    /// table, as ISO 1058 A.2.1 prints it, and of a feed the arithmetic code of all nines, whose number is beyond any
    /// machine. The highest number of the other methods is taken at its word, because a machine may have that speed.
    Rapid,
}

impl Speed {
    /// The speed, where the code says a number.
    pub fn number(self) -> Option<f64> {
        if let Speed::Is(speed) = self { Some(speed) } else { None }
    }
}

/// Why a code says no speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BadCode {
    /// A symbolic code without a value in the format.
    Unlisted,
    /// An arithmetic code whose second digit is zero though not all are (note to A.2.2).
    SecondDigitZero,
    /// Digits that no code of the method has.
    Digits,
}

/// A code: its number, and how many digits it is written with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Code {
    /// The number.
    pub number: i64,
    /// How many digits it has, leading zeros with them.
    pub digits: u16,
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:0width$}", self.number, width = usize::from(self.digits))
    }
}

/// Why a speed has no code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoCode {
    /// It is below what the method can say; this is the least.
    Below(f64),
    /// It is above what the method can say; this is the greatest.
    Above(f64),
    /// The format gives no values to symbolic codes.
    NoTable,
    /// The method has no codes of so many digits.
    Digits,
    /// It is no speed: negative, or no number.
    NotASpeed,
}

/// How the F or S words of a format say a speed.
#[derive(Clone, Copy, Debug)]
pub struct Coding<'a> {
    /// The method of annex A.
    pub method: FeedCoding,
    /// It says feeds, whose highest code is rapid traverse; else spindle speeds.
    pub feed: bool,
    /// Digits of the word.
    pub digits: u16,
    /// Digits behind its implicit decimal sign; only the reciprocal of time and the direct method have some.
    pub places: u8,
    /// Places by which the geometric table is moved left (ISO 1058 A.2.3).
    pub shift: u8,
    /// The reciprocal of time is this divided by minutes: 1, or 10.
    pub scale: f64,
    /// The values of symbolic codes.
    pub table: Option<&'a BTreeMap<String, f64>>,
}

impl<'a> Coding<'a> {
    /// How the words of an address, F or S, say a speed under a control.
    pub fn of(control: &'a Control, address: u8) -> Coding<'a> {
        let stated = &control.format.itemized;
        let (method, table) = match address {
            b'S' => (control.spindle, stated.symbolic_speeds.as_ref()),
            _ => (control.feed, stated.symbolic_feeds.as_ref()),
        };
        let designation = control.designation(address);
        Coding {
            method,
            feed: address != b'S',
            digits: designation.map_or(0, |word| u16::from(word.width())),
            places: designation.map_or(0, |word| word.after),
            shift: stated.decimal_shift.unwrap_or(0),
            scale: control.time_scale,
            table,
        }
    }

    /// The same under another method: what G93 and G94 change.
    pub fn under(self, method: FeedCoding) -> Coding<'a> {
        Coding { method, ..self }
    }

    /// What a code says, as it stands on the tape with its digits. Of the reciprocal of time it is the rate per minute,
    /// to which the length of the block makes a speed ([`reciprocal`]).
    pub fn decode(&self, code: Code) -> Result<Speed, BadCode> {
        match self.method {
            FeedCoding::TimeReciprocal => Ok(Speed::Is(direct::decode(code.number, self.places) / self.scale)),
            FeedCoding::Direct => Ok(Speed::Is(direct::decode(code.number, self.places))),
            FeedCoding::Arithmetic if self.feed && arithmetic::is_highest(code) => Ok(Speed::Rapid),
            FeedCoding::Arithmetic => arithmetic::decode(code).map(Speed::Is),
            FeedCoding::Geometric => geometric::decode(code.number, self.shift),
            FeedCoding::Symbolic => symbolic::decode(self.table, code.number).map(Speed::Is).ok_or(BadCode::Unlisted),
        }
    }

    /// The highest code, where it is rapid traverse.
    pub fn rapid(&self) -> Option<Code> {
        let highest =
            10_i64.checked_pow(u32::from(self.digits)).map(|above| Code { number: above - 1, digits: self.digits });
        highest.filter(|code| self.feed && self.decode(*code) == Ok(Speed::Rapid))
    }

    /// The code of a speed; of the reciprocal of time, that of a rate per minute.
    pub fn encode(&self, speed: f64) -> Result<Code, NoCode> {
        if !(speed.is_finite() && speed >= 0.0) {
            return Err(NoCode::NotASpeed);
        }
        match self.method {
            FeedCoding::TimeReciprocal => reciprocal::encode(speed, self.scale, self.digits, self.places),
            FeedCoding::Direct => direct::encode(speed, self.digits, self.places),
            FeedCoding::Arithmetic => match arithmetic::encode(speed, self.digits)? {
                // Rapid traverse, and not this speed.
                code if self.feed && arithmetic::is_highest(code) => {
                    Err(NoCode::Above(arithmetic::decode(Code { number: code.number - 1, ..code }).unwrap_or(speed)))
                }
                code => Ok(code),
            },
            FeedCoding::Geometric => geometric::encode(speed, self.shift),
            FeedCoding::Symbolic => symbolic::encode(self.table, speed, self.digits),
        }
    }
}

/// The method of a word whose format states none. ISO 1058 has three, told apart by their digits (annex A); annex E of
/// ISO 2539 uses the direct one.
pub(crate) fn method_of_digits(standard: Standard, digits: u8) -> FeedCoding {
    match (standard, digits) {
        (Standard::Iso1058, 1) => FeedCoding::Symbolic,
        (Standard::Iso1058, 2) => FeedCoding::Geometric,
        (Standard::Iso1058, 3..=5) => FeedCoding::Arithmetic,
        _ => FeedCoding::Direct,
    }
}

impl From<SpindleCoding> for FeedCoding {
    fn from(coding: SpindleCoding) -> FeedCoding {
        match coding {
            SpindleCoding::Arithmetic => FeedCoding::Arithmetic,
            SpindleCoding::Geometric => FeedCoding::Geometric,
            SpindleCoding::Symbolic => FeedCoding::Symbolic,
            SpindleCoding::Direct => FeedCoding::Direct,
        }
    }
}

/// The entry nearest in ratio to a speed above zero, of some above zero; the slower one of two that are as near.
fn nearest(speed: f64, values: impl Iterator<Item = (i64, f64)>) -> Option<(i64, f64)> {
    let ratio = |value: f64| f64::max(speed / value, value / speed);
    let nearer = |best: (i64, f64), next: (i64, f64)| {
        let (one, other) = (ratio(best.1), ratio(next.1));
        if other < one || other == one && next.1 < best.1 { next } else { best }
    };
    values.reduce(nearer)
}
