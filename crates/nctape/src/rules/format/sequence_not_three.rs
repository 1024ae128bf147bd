//! SPEC-17: the detail does not give N three digits.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "sequence-number-format-not-three",
    title: "The detail does not give N three digits.",
    verdicts: Verdicts::positioning("SPEC-17", Severity::Error),
    clauses: &[Clause::Iso1058("3.3.4.1")],
    page: page!("SPEC-17"),
};

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if word.address == 'N' && word.digits.len() == 1 && word.before != 3 {
            let message = format!("{}: a sequence number has exactly 3 digits.", word.text());
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
