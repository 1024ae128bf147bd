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
use crate::format::{Classification, Control, Detail, FormatDiagnostic, Standard};
use crate::rules::{Rule, word};

/// Judges a classification of an ISO format.
pub(crate) fn check_classification(found: &Classification, _: &Control, sink: &mut Sink<'_>) {
    class_contouring::check(found, sink);
    class_positioning::check(found, sink);
    class_system::check(found, sink);
    class_unit::check(found, sink);
    class_angles::check(found, sink);
    class_digits::check(found, sink);
    class_rising::check(found, sink);
    super::number::turns_recommended::check(found, sink);
}

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
    super::number::both_zeros::check(detail, control, sink);
    super::feed::short_reciprocal::check(detail, control, sink);
    function_digits::check(detail, control, sink);
    short_sequence::check(detail, control, sink);
    sequence_not_three::check(detail, control, sink);
    two_digit_functions::check(detail, control, sink);
    both_in_1058::check(detail, control, sink);
    unassigned_letters::check(detail, control, sink);
    parameters_in_1058::check(detail, control, sink);
    shorthand_disagrees::check(detail, control, sink);
    word::undeclared_meaning::check(detail, control, sink);
}

/// Judges the itemized data.
pub(crate) fn check_itemized(control: &Control, problems: &mut Vec<FormatDiagnostic>) {
    super::feed::not_in_1058::check(control, problems);
}

/// Reports a letter of the classification that is not one of those allowed at its place.
fn check_letter(
    rule: &'static Rule,
    found: &Classification,
    index: usize,
    allowed: &[(char, &str)],
    sink: &mut Sink<'_>,
) {
    let at = found.letters.get(index);
    if at.is_some_and(|(letter, _)| allowed.iter().any(|choice| choice.0 == *letter)) {
        return;
    }
    let choices: Vec<String> = allowed.iter().map(|(letter, meaning)| format!("{letter} ({meaning})")).collect();
    let (range, what) = match at {
        Some((letter, range)) => (range.clone(), format!("is {letter}")),
        None => (found.letters.last().map_or(0..0, |last| last.1.end..last.1.end), "is missing".to_owned()),
    };
    let message = format!("Letter {} of the classification {what}; it must be {}.", index + 1, choices.join(" or "));
    sink.report(rule, range, message);
}

/// Reports a field of the format as a whole.
pub(super) fn report_field(
    rule: &'static Rule,
    standard: Standard,
    path: &str,
    message: &str,
    problems: &mut Vec<FormatDiagnostic>,
) {
    let mut found = Vec::new();
    Sink::new(standard, &mut found).report(rule, 0..0, message.to_owned());
    problems.extend(found.into_iter().map(|diagnostic| FormatDiagnostic { path: path.to_owned(), diagnostic }));
}
