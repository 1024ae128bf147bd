//! SPEC-13: a dimension letter has not two or three digits.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-designation-length",
    title: "A dimension letter has not two or three digits.",
    verdicts: Verdicts::all("SPEC-13", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("D.3.1")],
    page: page!("SPEC-13"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if crate::format::DIMENSION_LETTERS.contains(word.address)
            && !is_declared_letter(word.address, control)
            // What cuts the digits short is the fault then.
            && !detail.stray.iter().any(|stray| stray.start == word.range.end)
            && (word.digits.len() > 3 && !crate::rules::number::both_zeros::holds(&word.digits)
                || word.digits.is_empty()
                || word.digits.len() == 1 && !"ABCDE".contains(word.address))
        {
            let message = format!(
                "{} has {}; a dimension letter has two, before and behind the decimal sign, or three where zeros may be \
                 left out (X+42, X+042, X+420).",
                word.text(),
                digits(word.digits.len() as u16)
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
