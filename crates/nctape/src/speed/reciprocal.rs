//! The reciprocal of time (ISO 2539 A.1): how many times a minute holds the block.
//!
//! On a line it is feed divided by length (A.1.1). On an arc the standard contradicts itself: A.1.2 has the radians per
//! minute, feed divided by radius; the circular tape of annex E has the reciprocal of time there too. The format says
//! which (`arcFeed`). RS-274's feed rate number is ten times that (`timeScale`).

use super::direct::{self, greatest};
use super::{Code, NoCode};
use crate::format::{ArcFeed, power_of_ten};

/// What a rate is counted against: the feed is the rate times this length.
///
/// `radius` is that of an arc, `None` on any other path; `length` is the length of the path.
pub fn base(length: f64, radius: Option<f64>, reading: ArcFeed) -> f64 {
    match (radius, reading) {
        (Some(radius), ArcFeed::Radians) => radius,
        _ => length,
    }
}

/// The code of a rate per minute: the greatest that is not above it, as every block of annex E has it (300/11,716 =
/// 25,6 is written 25), so that the feed is never exceeded.
pub fn encode(rate: f64, scale: f64, digits: u16, places: u8) -> Result<Code, NoCode> {
    let most = greatest(digits).ok_or(NoCode::Digits)?;
    let unit = power_of_ten(places) as f64;
    let exact = rate * scale * unit;
    // A millionth below a whole number is that number: lengths and feeds are given with so many figures, and no machine
    // keeps a feed as well.
    let whole = exact.round();
    let number = if (whole - exact).abs() <= 1e-6 * exact { whole } else { exact.floor() };
    if number < 1.0 && rate > 0.0 {
        return Err(NoCode::Below(direct::decode(1, places) / scale));
    }
    // A rate above the greatest is refused and not cut down: the block would take longer than was asked for.
    if number > most as f64 {
        return Err(NoCode::Above(direct::decode(most, places) / scale));
    }
    Ok(Code { number: number as i64, digits })
}
