//! The arithmetic progression (ISO 2539 A.2, ISO 1058 A.1): three, four or five digits, of which the first is three more
//! than the digits before the decimal sign and the others are the leading digits of the speed.

use super::{BadCode, Code, NoCode, decimal};
use crate::format::power_of_ten;

/// What a code says.
pub fn decode(code: Code) -> Result<f64, BadCode> {
    if !(3..=5).contains(&code.digits) || code.number < 0 {
        return Err(BadCode::Digits);
    }
    let scale = power_of_ten(code.digits as u8 - 1);
    let (first, mantissa) = (code.number / scale, code.number % scale);
    if first > 9 {
        return Err(BadCode::Digits);
    }
    if code.number == 0 {
        return Ok(0.0);
    }
    // The second digit is never zero unless all are (note to A.2.2).
    if mantissa < scale / 10 {
        return Err(BadCode::SecondDigitZero);
    }
    Ok(scaled(mantissa, first - 3 - i64::from(code.digits - 1)))
}

/// The code of a speed, rounded half up: 15,25 is 5153, where half to even would be 5152 (A.2.2).
pub fn encode(speed: f64, digits: u16) -> Result<Code, NoCode> {
    if !(3..=5).contains(&digits) {
        return Err(NoCode::Digits);
    }
    if speed == 0.0 {
        return Ok(Code { number: 0, digits });
    }
    let scale = power_of_ten(digits as u8 - 1);
    let (mantissa, before) = decimal::leading(speed, digits - 1);
    let first = i64::from(before) + 3;
    let places = i64::from(digits - 1);
    if first < 0 {
        return Err(NoCode::Below(scaled(scale / 10, -3 - places)));
    }
    if first > 9 {
        return Err(NoCode::Above(scaled(scale - 1, 6 - places)));
    }
    Ok(Code { number: first * scale + mantissa, digits })
}

/// The code of all nines, which annex A gives to rapid traverse.
pub fn is_highest(code: Code) -> bool {
    (3..=5).contains(&code.digits) && code.number == power_of_ten(code.digits as u8) - 1
}

/// A whole number times a power of ten from -11 to 9, by one exact division or multiplication.
pub(super) fn scaled(number: i64, exponent: i64) -> f64 {
    let power = power_of_ten(exponent.unsigned_abs() as u8) as f64;
    if exponent < 0 { number as f64 / power } else { number as f64 * power }
}
