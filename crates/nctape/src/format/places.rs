//! Where the decimal sign is understood: the one thing of a format that no tape shows, moved for all dimension words
//! together.

use super::{Designation, Detail, Format, Zeros};

/// The decimal places of a format's dimension words, and how far they can be moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Places {
    /// Places behind the decimal sign of the first dimension word.
    pub places: u8,
    /// The fewest that it can have, with every dimension word moved alike.
    pub least: u8,
    /// The most that it can have.
    pub greatest: u8,
}

/// The most digits that a designation can say before or behind the decimal sign: it has one digit for each count.
const MOST: u8 = 9;

impl Places {
    /// The places of a format; `None` where its detail has no dimension word.
    pub fn of(format: &Format) -> Option<Places> {
        let detail = Detail::read(&format.detail, format.standard);
        let words = || detail.words.iter().filter(|word| word.dimension);
        let first = words().next()?;
        let left = words().map(|word| word.after.min(MOST - word.before)).min()?;
        let right = words().map(|word| (word.before - least_before(word)).min(MOST - word.after)).min()?;
        Some(Places { places: first.after, least: first.after - left, greatest: first.after + right })
    }
}

/// A designation of three digits, such as 420, would begin with 0 if no digit stood before the sign, and would then
/// say that leading zeros are left out.
fn least_before(word: &Designation) -> u8 {
    u8::from(word.digits.len() > 2 && word.zeros != Zeros::LeadingOmitted).min(word.before)
}

impl Format {
    /// The same format with the decimal sign of every dimension word moved, so that the first has `places` behind it.
    /// The count of digits of each word stays. `None` where a word has not the digits for it.
    ///
    /// ```
    /// use nctape::{Format, Standard};
    /// let format = Format::new(Standard::Iso2539, "N3.G2.X+42.YD032.F4*");
    /// assert_eq!(format.with_places(3).unwrap().detail, "N3.G2.X+33.YD023.F4*");
    /// assert!(format.with_places(6).is_none());
    /// ```
    pub fn with_places(&self, places: u8) -> Option<Format> {
        let now = Places::of(self)?;
        if !(now.least..=now.greatest).contains(&places) {
            return None;
        }
        let detail = Detail::read(&self.detail, self.standard);
        let mut text: Vec<char> = self.detail.chars().collect();
        let at = |byte: usize| self.detail[..byte].chars().count();
        for word in detail.words.iter().filter(|word| word.dimension) {
            // Not negative, because `places` is within what every word allows.
            let after = word.after + places - now.places;
            let before = word.width() - after;
            let digits = (at(word.range.start)..at(word.range.end)).filter(|&index| text[index].is_ascii_digit());
            let digits: Vec<usize> = digits.collect();
            // The mark for zeros stands before or behind the two counts.
            let first = usize::from(word.zeros == Zeros::LeadingOmitted);
            for (index, count) in [(first, before), (first + 1, after)] {
                text[digits[index]] = char::from(b'0' + count);
            }
        }
        Some(Format { detail: text.into_iter().collect(), ..self.clone() })
    }
}
