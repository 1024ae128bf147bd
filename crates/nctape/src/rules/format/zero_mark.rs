//! SPEC-14: a three-digit designation neither begins nor ends with 0.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "no-zero-mark",
    title: "A three-digit designation neither begins nor ends with 0.",
    verdicts: Verdicts::all("SPEC-14", Severity::Error),
    clauses: &[Clause::Both("D.3.1")],
    page: page!("SPEC-14"),
};

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if word.dimension && word.digits.len() == 3 && !word.digits.starts_with('0') && !word.digits.ends_with('0') {
            let message = format!(
                "{} has three digits; the first is 0 where leading zeros may be left out, the last is 0 where trailing zeros \
                 may.",
                word.text()
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
