//! The geometric progression (ISO 2539 A.3, ISO 1058 A.2): two digits of a table. ISO 2539 does not print the table; as
//! it is to agree with ISO 1058 (1.2), that one's is taken for both.

use super::arithmetic::scaled;
use super::{BadCode, Code, NoCode, Speed, nearest};

/// The R20 series from 1 to 10 in hundredths: the ratios of the table (ISO 1058 A.2.1), code by code. The printed table
/// holds rounded values, up to 1,22 % off the exact power, so it is a table and not a power.
const R20_HUNDREDTHS: [i64; 20] =
    [100, 112, 125, 140, 160, 180, 200, 224, 250, 280, 315, 355, 400, 450, 500, 560, 630, 710, 800, 900];

/// The code of rapid traverse.
pub const RAPID: i64 = 99;

/// The entry of a code, moved left by some places (A.2.3).
fn entry(code: i64, shift: u8) -> f64 {
    scaled(R20_HUNDREDTHS[(code % 20) as usize], code / 20 - 2 - i64::from(shift.min(9)))
}

/// What a code says: 00 is stop, 99 rapid traverse.
pub fn decode(code: i64, shift: u8) -> Result<Speed, BadCode> {
    match code {
        0 => Ok(Speed::Is(0.0)),
        1..RAPID => Ok(Speed::Is(entry(code, shift))),
        RAPID => Ok(Speed::Rapid),
        _ => Err(BadCode::Digits),
    }
}

/// The code of the entry nearest in ratio: at most half a step of the table beside the speed, which is 7 % where the
/// steps are widest (1,40 to 1,60).
pub fn encode(speed: f64, shift: u8) -> Result<Code, NoCode> {
    if speed == 0.0 {
        return Ok(Code { number: 0, digits: 2 });
    }
    // One beyond either end: what is nearer to those than to the table has no code.
    match nearest(speed, (0..=RAPID).map(|code| (code, entry(code, shift)))) {
        Some((number, _)) if (1..RAPID).contains(&number) => Ok(Code { number, digits: 2 }),
        Some((0, _)) => Err(NoCode::Below(entry(1, shift))),
        _ => Err(NoCode::Above(entry(RAPID - 1, shift))),
    }
}
