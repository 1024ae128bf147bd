//! SPEC-13: a dimension letter has not two or three digits.

use crate::format::{DIMENSION_LETTERS, Designation, Detail, Sign};
use crate::rules::number::both_zeros;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-designation-length",
    title: "A dimension letter has not two or three digits.",
    verdicts: Verdicts::all("SPEC-13", Severity::Error),
    clauses: &[Clause::Both("D.3.1")],
    page: page!("SPEC-13"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        // What cuts the digits short is the fault then.
        if is_wrong(word, control) && !detail.is_cut_short(word) {
            let what = if word.digits.len() > 1 && word.width() == 0 {
                "says that the word has no digit at all".to_owned()
            } else if word.digits.len() == 1 && word.sign != Sign::Positive && "ABCDE".contains(word.address) {
                "has a sign mark, but not the two digits of a dimension".to_owned()
            } else {
                format!("has {}", digits(word.digits.len() as u16))
            };
            let message = format!(
                "{} {what}; a dimension letter has two, before and behind the decimal sign, or three where zeros may be \
                 left out (X+42, X+042, X+420).",
                word.text(),
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}

/// A dimension letter whose digits say no dimension; one digit behind A to E is an indexed motion or a function.
pub(super) fn is_wrong(word: &Designation, control: &Control) -> bool {
    if !DIMENSION_LETTERS.contains(word.address) || is_declared_letter(word.address, control) {
        return false;
    }
    // NUM-07 says it where it has a verdict.
    let said = both_zeros::holds(&word.digits) && both_zeros::RULE.verdicts.under(control.standard()).is_some();
    match word.digits.len() {
        0 => true,
        1 => !"ABCDE".contains(word.address) || word.sign != Sign::Positive || word.width() == 0,
        2 | 3 => word.width() == 0,
        _ => !said,
    }
}
