//! Elements (5.13): integers, reals, literals and keywords.

use super::words::Key;
use std::ops::Range;

/// What an element is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ElementKind {
    /// An integer number (5.9).
    Integer,
    /// A real number: it has a decimal point (5.10).
    Real,
    /// A literal character string (5.7).
    Literal,
    /// A keyword (5.11).
    Keyword,
    /// None of these: nothing between two separators, or what cannot be read.
    Unreadable,
}

impl ElementKind {
    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            ElementKind::Integer => "an integer number",
            ElementKind::Real => "a real number",
            ElementKind::Literal => "a literal",
            ElementKind::Keyword => "a keyword",
            ElementKind::Unreadable => "nothing that can be read",
        }
    }
}

/// One element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// What it is.
    pub kind: ElementKind,
    /// Its place, in bytes of the stream.
    pub(super) from: u32,
    pub(super) to: u32,
    /// The bits of the number, or the key of the keyword.
    pub(super) bits: u64,
}

impl Element {
    pub(crate) fn range(&self) -> Range<usize> {
        self.from as usize..self.to as usize
    }

    /// Its value, where it is a number that can be held.
    pub fn value(&self) -> Option<f64> {
        match self.kind {
            ElementKind::Integer | ElementKind::Real => {
                Some(f64::from_bits(self.bits)).filter(|value| value.is_finite())
            }
            _ => None,
        }
    }

    /// Its value, where it is a whole number, whether it is written as an integer or as a real.
    pub fn whole(&self) -> Option<i64> {
        // Up to 2^53 an f64 holds every whole number.
        const MOST: f64 = 9_007_199_254_740_992.0;
        self.value().filter(|value| value.trunc() == *value && value.abs() <= MOST).map(|value| value as i64)
    }

    /// Its word, where it is a keyword.
    pub fn key(&self) -> Option<Key> {
        (self.kind == ElementKind::Keyword).then_some(Key(self.bits))
    }
}
