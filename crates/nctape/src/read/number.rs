//! The number of a word: exact, in least input increments.

use crate::format::{Control, Designation, Zeros};

/// What is wrong with the characters of a number. One at most: the first one found stands for what follows from it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NumberFault {
    /// Nothing.
    None,
    /// There is no digit at all.
    Empty,
    /// A decimal sign stands at this offset from the block's start.
    DecimalSign(u32),
    /// A sign stands behind the first digit, or a second one, at this offset.
    SignInside(u32),
    /// A character that is reported for itself stands in the number.
    Foreign,
    /// The number stands in the column of another word: it has the shape of the word beside it.
    Column,
}

/// A dimension word has at most 9 + 9 digits by its designation; a number of more than 18 digits does not fit i64.
pub(crate) const MOST_DIGITS: u16 = 18;

/// A number as it is being read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number {
    pub sign: Option<u8>,
    pub digits: u16,
    pub fault: NumberFault,
    magnitude: i64,
}

impl Number {
    pub(crate) const EMPTY: Number = Number { sign: None, digits: 0, fault: NumberFault::None, magnitude: 0 };

    pub(crate) fn push_digit(&mut self, digit: u8) {
        self.digits = self.digits.saturating_add(1);
        if self.digits <= MOST_DIGITS {
            self.magnitude = self.magnitude * 10 + i64::from(digit);
        }
    }

    pub(crate) fn push_sign(&mut self, sign: u8, at: u32) {
        if self.sign.is_none() && self.digits == 0 {
            self.sign = Some(sign);
        } else {
            self.fail(NumberFault::SignInside(at));
        }
    }

    pub(crate) fn fail(&mut self, fault: NumberFault) {
        if self.fault == NumberFault::None {
            self.fault = fault;
        }
    }

    /// It is nothing but zeros, and no more of them than its dimension word has digits.
    pub(crate) fn is_zero_of(&self, designation: Option<&Designation>) -> bool {
        let width = designation.filter(|word| word.dimension).map_or(0, |word| u16::from(word.width()));
        self.fault == NumberFault::None && (1..=width).contains(&self.digits) && self.magnitude == 0
    }

    /// The value of the number under a designation: `None` where its digits do not say it.
    ///
    /// A number with all its digits is exact. With fewer, it is read only where the designation lets those zeros be
    /// left out: a digit that is missing elsewhere may have been any digit.
    pub(crate) fn value(&self, designation: Option<&Designation>) -> Option<i64> {
        if self.fault != NumberFault::None || self.digits == 0 || self.digits > MOST_DIGITS {
            return None;
        }
        // A code is neither positive nor negative: the sign of such a word is reported (NUM-14), and its number holds.
        let signed = designation.is_none_or(|word| word.dimension);
        let magnitude = match designation {
            Some(word) if word.dimension => {
                let width = u16::from(word.width());
                match word.zeros {
                    _ if self.digits == width => self.magnitude,
                    Zeros::LeadingOmitted if self.digits < width => self.magnitude,
                    Zeros::TrailingOmitted if self.digits < width => {
                        self.magnitude * crate::format::power_of_ten((width - self.digits) as u8)
                    }
                    _ => return None,
                }
            }
            _ => self.magnitude,
        };
        Some(if signed && self.sign == Some(b'-') { -magnitude } else { magnitude })
    }
}

/// The value of a word in the unit of the format.
pub(crate) fn in_unit(control: &Control, address: u8, value: i64) -> f64 {
    let places = control.designation(address).map_or(0, |word| word.after);
    value as f64 / crate::format::power_of_ten(places) as f64
}
