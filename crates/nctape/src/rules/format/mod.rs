//! SPEC: the format specification itself.

pub(crate) mod angles_undeclared;
pub(crate) mod both_in_1058;
pub(crate) mod class_angles;
pub(crate) mod class_contouring;
pub(crate) mod class_digits;
pub(crate) mod class_positioning;
pub(crate) mod class_rising;
pub(crate) mod class_system;
pub(crate) mod class_unit;
pub(crate) mod dimension_digits;
pub(crate) mod empty_detail;
pub(crate) mod function_digits;
pub(crate) mod idle_value;
pub(crate) mod letter_order;
pub(crate) mod motion_count;
pub(crate) mod no_asterisk;
pub(crate) mod parameters_in_1058;
pub(crate) mod sequence_not_three;
pub(crate) mod short_sequence;
pub(crate) mod shorthand_disagrees;
pub(crate) mod stray_character;
pub(crate) mod tabs_disagree;
pub(crate) mod two_digit_functions;
pub(crate) mod unassigned_letters;
pub(crate) mod unknown_field;
pub(crate) mod unusable_value;
pub(crate) mod zero_mark;

use crate::diagnostic::Sink;
use crate::format::{Classification, Control, Designation, Detail, FormatDiagnostic, Standard};
use crate::rules::number::both_zeros;
use crate::rules::{Rule, word};

/// Judges a classification of an ISO format.
pub(crate) fn check_classification(found: &Classification, control: &Control, sink: &mut Sink<'_>) {
    let class_kind = match control.standard() {
        Standard::Iso1058 => class_positioning::check,
        _ => class_contouring::check,
    };
    for check in [class_kind, class_system::check, class_unit::check] {
        // Where a letter is missing, those behind it stand one place early.
        if check(found, sink) && found.letters.len() < LETTERS {
            break;
        }
    }
    class_angles::check(found, sink);
    class_digits::check(found, sink);
    class_rising::check(found, sink);
    super::number::turns_recommended::check(found, sink);
}

/// Judges the shorthand of an EIA format by itself.
pub(crate) fn check_shorthand(text: &str, sink: &mut Sink<'_>) {
    shorthand_disagrees::check_alone(text, sink);
}

/// The letters of a classification that are not left to choice: kind, system and unit.
const LETTERS: usize = 3;

/// Judges a detail.
pub(crate) fn check_detail(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    empty_detail::check(detail, control, sink);
    stray_character::check(detail, control, sink);
    if detail.words.is_empty() {
        return;
    }
    angles_undeclared::check(detail, control, sink);
    motion_count::check(detail, control, sink);
    tabs_disagree::check(detail, control, sink);
    no_asterisk::check(detail, control, sink);
    letter_order::check(detail, control, sink);
    dimension_digits::check(detail, control, sink);
    zero_mark::check(detail, control, sink);
    both_zeros::check(detail, control, sink);
    super::feed::short_reciprocal::check(detail, control, sink);
    function_digits::check(detail, control, sink);
    short_sequence::check(detail, control, sink);
    sequence_not_three::check(detail, control, sink);
    two_digit_functions::check(detail, control, sink);
    both_in_1058::check(detail, control, sink);
    unassigned_letters::check(detail, control, sink);
    parameters_in_1058::check(detail, control, sink);
    shorthand_disagrees::check(detail, control, sink);
    super::feed::not_in_1058::check_detail(detail, control, sink);
    word::undeclared_meaning::check(detail, control, sink);
    word::compensation_letter::check(detail, control, sink);
}

/// Judges the itemized data.
pub(crate) fn check_itemized(control: &Control, problems: &mut Vec<FormatDiagnostic>) {
    super::feed::not_in_1058::check(control, problems);
    // Without a detail it is not known what axes and words there are.
    if !control.detail.words.is_empty() {
        word::compensation_letter::check_itemized(control, problems);
        idle_value::check(control, problems);
    }
}

/// The words of a detail that stand for a motion are not to be counted: one of them cannot be read, or stands twice.
fn is_uncountable(detail: &Detail, control: &Control) -> bool {
    let words = &detail.words;
    let twice = |index: usize| words[..index].iter().any(|before| before.address == words[index].address);
    let unread = |word: &Designation| dimension_digits::is_wrong(word, control) || both_zeros::holds(&word.digits);
    !detail.stray.is_empty() || words.iter().any(unread) || (0..words.len()).any(twice)
}

/// Reports a letter of the classification that is not one of those allowed at its place; tells whether it is wrong.
fn check_letter(
    rule: &'static Rule,
    found: &Classification,
    index: usize,
    allowed: &[(char, &str)],
    sink: &mut Sink<'_>,
) -> bool {
    let at = found.letters.get(index);
    if at.is_some_and(|(letter, _)| allowed.iter().any(|choice| choice.0 == *letter)) {
        return false;
    }
    let choices: Vec<String> = allowed.iter().map(|(letter, meaning)| format!("{letter} ({meaning})")).collect();
    let (range, what) = match at {
        Some((letter, range)) => (range.clone(), format!("is {letter}")),
        None => (found.letters.last().map_or(0..0, |last| last.1.end..last.1.end), "is missing".to_owned()),
    };
    let place = index + 1;
    let mut message = format!("Letter {place} of the classification {what}; it must be {}.", choices.join(" or "));
    if found.is_empty() {
        message.push_str(" The classification is empty: write one, or leave the field out.");
    } else if found.letters.len() < LETTERS {
        message.push_str(" Three letters stand before the digits: the kind of control, its system and the unit.");
    }
    sink.report(rule, range, message);
    true
}

/// Reports a field of the format as a whole; `text` is empty where the field is no text.
pub(super) fn report_field(
    rule: &'static Rule,
    standard: Standard,
    (path, text): (&str, &str),
    message: &str,
    problems: &mut Vec<FormatDiagnostic>,
) {
    let mut found = Vec::new();
    Sink::new(standard, &mut found).report(rule, 0..text.len(), message.to_owned());
    problems.extend(found.into_iter().map(|found| FormatDiagnostic::of(path, text, found)));
}
