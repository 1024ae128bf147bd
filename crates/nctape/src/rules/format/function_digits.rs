//! SPEC-15: a letter that is no dimension has not one digit.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-function-designation",
    title: "A letter that is no dimension has not one digit.",
    verdicts: Verdicts::all("SPEC-15", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("D.3.2")],
    page: page!("SPEC-15"),
};

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if !crate::format::DIMENSION_LETTERS.contains(word.address) && word.digits.len() != 1 {
            let message = format!(
                "{} has {}; the address of a word that is no dimension has one, the count of its digits (F4).",
                word.text(),
                digits(word.digits.len() as u16)
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
