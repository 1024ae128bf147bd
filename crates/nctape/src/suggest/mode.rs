//! Absolute or incremental dimensions, where the tape does not select them.

use super::detail::SignMark;
use super::survey::Survey;
use crate::format::{Detail, Dimensions, Format, Sign};

/// The marks of signed words worth trying, the likelier first.
pub(super) fn likely(survey: &Survey) -> Vec<SignMark> {
    if survey.selects_dimensions {
        vec![SignMark::Both]
    } else if !survey.signed() {
        vec![SignMark::Absolute]
    } else if looks_incremental(survey) {
        vec![SignMark::Incremental, SignMark::Absolute]
    } else {
        vec![SignMark::Absolute, SignMark::Incremental]
    }
}

/// A contour that closes has increments whose sum is zero. Failing that, the steps of the tool are shorter than its
/// coordinates: read as absolute dimensions the steps are the differences of the words, read as increments the words
/// themselves.
fn looks_incremental(survey: &Survey) -> bool {
    // Every increment has its direction: an axis that never has a sign is absolute, and so are the others.
    if survey.has_unsigned_axis() {
        return false;
    }
    let mut axes = survey.coordinates();
    axes.retain(|axis| axis.iter().any(|value| *value != 0));
    // What goes out comes back: increments of an axis that moves more than twice do not all have one sign.
    let one_way = |axis: &Vec<i128>| axis.iter().all(|value| *value >= 0) || axis.iter().all(|value| *value <= 0);
    if axes.iter().any(|axis| axis.iter().filter(|value| **value != 0).count() > 2 && one_way(axis)) {
        return false;
    }
    if axes.iter().all(|axis| axis.len() > 1 && axis.iter().sum::<i128>() == 0) {
        return true;
    }
    let differences: u128 = axes.iter().flat_map(|axis| axis.windows(2).map(|pair| pair[1].abs_diff(pair[0]))).sum();
    let words: u128 = axes.iter().flat_map(|axis| axis.iter().skip(1).map(|value| value.unsigned_abs())).sum();
    words < differences
}

/// Why the format has the dimensions that it has.
pub(super) fn reason(survey: &Survey, format: &Format) -> &'static str {
    let words = Detail::read(&format.detail, format.standard).words;
    let incremental = format.itemized.dimensions == Some(Dimensions::Incremental)
        || words.iter().any(|word| word.dimension && word.sign == Sign::Incremental);
    match (incremental, looks_incremental(survey)) {
        (true, true) => "Dimensions are incremental: the words add up to a closed path, or to the shorter steps.",
        (false, false) => "Dimensions are absolute: so the steps of the tool are the shorter ones.",
        (true, false) => "Dimensions are incremental.",
        (false, true) => "Dimensions are absolute.",
    }
}
