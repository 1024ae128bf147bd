//! Numbers as words of a format.

use super::{Fault, TapeWriter};
use crate::format::{Designation, Sign, power_of_ten};

impl TapeWriter<'_> {
    /// A whole number without sign: a function, a tool.
    pub(crate) fn code_word(&self, address: char, number: i64) -> Result<String, Fault> {
        let designation = self.designation(address)?;
        let value = number as f64;
        if number < 0 {
            return Err(Fault::Negative { address, value });
        }
        digits(designation, number).ok_or(Fault::TooLong { address, value, before: designation.before })
    }

    /// A number in the unit of its word, with its sign where it has one.
    pub(crate) fn plain_word(&mut self, address: char, value: f64) -> Result<String, Fault> {
        let places = self.designation(address)?.after;
        let number = self.increments(value, places, address)?;
        self.dimension_word(address, number)
    }

    /// A number in units of its last place.
    pub(super) fn dimension_word(&self, address: char, number: i64) -> Result<String, Fault> {
        let designation = self.designation(address)?;
        let value = number as f64 / power_of_ten(designation.after) as f64;
        let signed = designation.dimension && designation.sign != Sign::Positive;
        if number < 0 && !signed {
            return Err(Fault::Negative { address, value });
        }
        let digits = digits(designation, number.saturating_abs());
        let digits = digits.ok_or(Fault::TooLong { address, value, before: designation.before })?;
        let sign = match (signed, number < 0) {
            (false, _) => "",
            (true, false) => "+",
            (true, true) => "-",
        };
        Ok(format!("{sign}{digits}"))
    }

    /// The whole number of last places nearest to a value.
    pub(super) fn increments(&mut self, value: f64, places: u8, address: char) -> Result<i64, Fault> {
        let exact = value * power_of_ten(places) as f64;
        let number = exact.round();
        // Beyond 2^53 not every whole number is one of f64's; no word of a tape is that long in earnest.
        if !(number.is_finite() && number.abs() < 9e15) {
            return Err(Fault::TooLong { address, value, before: self.designation(address)?.before });
        }
        self.rounding = self.rounding.max((exact - number).abs());
        Ok(number as i64)
    }

    pub(super) fn designation(&self, address: char) -> Result<&Designation, Fault> {
        u8::try_from(address).ok().and_then(|letter| self.control.designation(letter)).ok_or(Fault::NoWord(address))
    }
}

/// All digits of a number; `None` where the word has fewer.
fn digits(designation: &Designation, number: i64) -> Option<String> {
    let width = usize::from(designation.width());
    let text = format!("{number:0width$}");
    (text.len() <= width).then_some(text)
}
