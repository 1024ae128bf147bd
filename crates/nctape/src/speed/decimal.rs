//! Rounding as a person does it: by the decimal digits of a number, half up.

/// A number above zero by its leading digits: `digits` of them, as a whole number, and how many of all its digits stand
/// before the decimal sign (zero or less where it is below one: no digit, less a place for each zero behind the sign).
///
/// The digits are those of the shortest decimal that says the number, which is what was typed or printed. Its binary value
/// may lie a little below: 1,005 does, and is rounded to 1,01 all the same.
pub(super) fn leading(number: f64, digits: u16) -> (i64, i32) {
    let (written, before) = shortest(number);
    rounded(&written, before, i32::from(digits))
}

/// A number of zero or more in so many decimal places, as a whole number of the last place; `None` beyond `i64`.
pub(super) fn with_places(number: f64, places: u8) -> Option<i64> {
    if number == 0.0 {
        return Some(0);
    }
    let (written, before) = shortest(number);
    let wanted = before + i32::from(places);
    if wanted > 18 {
        return None;
    }
    let (value, now) = rounded(&written, before, wanted.max(0));
    // Rounding up to the next power of ten leaves one digit fewer behind than the places ask for.
    Some(if wanted < 0 { 0 } else { value * if now > before && wanted > 0 { 10 } else { 1 } })
}

/// The digits of the shortest decimal, and how many of them stand before the decimal sign.
fn shortest(number: f64) -> (Vec<u8>, i32) {
    let text = format!("{number:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).map(|digit| digit - b'0').collect();
    (digits, exponent.parse::<i32>().unwrap_or(0) + 1)
}

/// The first `wanted` digits rounded half up, and how many digits stand before the sign then.
fn rounded(written: &[u8], before: i32, wanted: i32) -> (i64, i32) {
    let digit = |place: usize| written.get(place).map_or(0, |&digit| i64::from(digit));
    let count = wanted.clamp(0, 18) as usize;
    let kept = (0..count).fold(0, |value, place| value * 10 + digit(place));
    let value = kept + i64::from(digit(count) >= 5);
    let full = crate::format::power_of_ten(count as u8);
    // 99,6 is 100: one digit more before the sign, and a zero fewer behind it.
    if value == full { ((value / 10).max(1), before + 1) } else { (value, before) }
}
