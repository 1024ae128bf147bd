//! The direct designation (ISO 2539 3.3.4.3, 3.3.4.4): the speed itself, as the parabolic tape of annex E has it.

use super::{Code, NoCode, decimal};
use crate::format::power_of_ten;

/// The speed of a number with an implicit decimal sign.
pub fn decode(number: i64, places: u8) -> f64 {
    number as f64 / power_of_ten(places) as f64
}

/// The code of a speed, rounded half up, as the arithmetic codes are; none that says more or less than the word can.
pub fn encode(speed: f64, digits: u16, places: u8) -> Result<Code, NoCode> {
    let most = greatest(digits).ok_or(NoCode::Digits)?;
    match decimal::with_places(speed, places) {
        Some(0) if speed > 0.0 => Err(NoCode::Below(decode(1, places))),
        Some(number) if number <= most => Ok(Code { number, digits }),
        _ => Err(NoCode::Above(decode(most, places))),
    }
}

/// The greatest number of so many digits; `None` of none, and of more than a number may have.
pub(super) fn greatest(digits: u16) -> Option<i64> {
    (1..=18).contains(&digits).then(|| power_of_ten(digits as u8) - 1)
}
