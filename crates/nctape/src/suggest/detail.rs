//! The shorthand of a suggested format.

use super::survey::{Seen, Survey};
use crate::format::{Standard, System};

/// What the signed dimension words of a suggestion are taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SignMark {
    Absolute,
    Incremental,
    Both,
}

/// The detail: letters in their order, digits as seen.
pub(super) fn detail(survey: &Survey, standard: Standard, mark: SignMark) -> String {
    let tab = if survey.system == System::Address { "" } else { "." };
    let words: Vec<String> = survey
        .letters
        .iter()
        .map(|seen| {
            let tab = if seen.address == b'N' { "" } else { tab };
            format!("{tab}{}", word(seen, survey, standard, mark))
        })
        .collect();
    match standard {
        Standard::Rs274 => format!("{}*", words.join(" ").to_ascii_lowercase()),
        _ => format!("{}*", words.concat()),
    }
}

fn word(seen: &Seen, survey: &Survey, standard: Standard, mark: SignMark) -> String {
    let letter = char::from(seen.address);
    if !seen.is_dimension() {
        let digits = match seen.address {
            b'N' if standard == Standard::Iso1058 => 3,
            b'N' => seen.longest.max(3),
            b'G' | b'M' => 2,
            _ => seen.longest,
        };
        // Y-1702 writes f21: a feed in inches per minute has one place behind the decimal sign.
        return match (standard, seen.address, digits) {
            (Standard::Rs274, b'F', 2..) => format!("{letter}{}1", digits - 1),
            _ => format!("{letter}{}", digits.min(9)),
        };
    }
    let sign = match (seen.signed > 0, standard, mark) {
        (false, _, SignMark::Both) if standard != Standard::Rs274 => "L",
        // An incremental dimension need not have its sign (3.3.3.4.3).
        (false, Standard::Iso2539, SignMark::Incremental) => "D",
        (false, ..) => "",
        (true, Standard::Rs274, _) | (true, _, SignMark::Absolute) => "+",
        (true, _, SignMark::Incremental) => "D",
        (true, _, SignMark::Both) => "L",
    };
    let (before, after) = places(seen, survey, standard);
    let digits = match (survey.shortens(), survey.leading_zeros_omitted()) {
        (false, _) => format!("{before}{after}"),
        (true, true) => format!("0{before}{after}"),
        (true, false) => format!("{before}{after}0"),
    };
    format!("{letter}{sign}{digits}")
}

/// Digits before and behind the decimal sign: a thousandth of a millimetre or a ten-thousandth of an inch, the
/// increments of contouring controls, where there are digits for it and one is left before the sign. All lengths have
/// the same increment, and so have all angles: a control has no other scale for one axis than for another.
fn places(seen: &Seen, survey: &Survey, standard: Standard) -> (u16, u16) {
    let increment = if standard == Standard::Rs274 { 4 } else { 3 };
    let is_angle = |seen: &Seen| matches!(seen.address, b'A'..=b'E');
    let alike = survey.letters.iter().filter(|other| other.is_dimension() && is_angle(other) == is_angle(seen));
    let digits = |seen: &Seen| seen.longest.min(18);
    let after = alike.map(|other| increment.min(digits(other).saturating_sub(1))).min().unwrap_or(0);
    let digits = digits(seen);
    let after = after.max(digits.saturating_sub(9)).min(digits);
    (digits - after, after)
}

/// The classification: system and counts as seen, millimetres and degrees assumed. EIA's shorthand is left out: it
/// explains and never decides.
pub(super) fn classification(survey: &Survey, standard: Standard) -> Option<String> {
    let kind = match standard {
        Standard::Rs274 => return None,
        Standard::Iso2539 => 'C',
        Standard::Iso1058 => 'L',
    };
    let is_motion = |seen: &&Seen| b"XYZUVWPQRABC".contains(&seen.address);
    let dimensions = survey.letters.iter().filter(|seen| is_motion(seen) && seen.is_dimension()).count();
    let motions = survey.letters.iter().filter(is_motion).count();
    let angular = survey.letters.iter().any(|seen| b"ABC".contains(&seen.address) && seen.is_dimension());
    let at_once = survey.axes_at_once.clamp(1, dimensions.max(1));
    let least = if survey.contours { 2.min(dimensions.max(1)) } else { 1 };
    let angles = if angular { "D" } else { "" };
    let system = survey.system.letter();
    Some(format!("{kind}{system}M{angles} {motions}{dimensions}{}", at_once.max(least)))
}
