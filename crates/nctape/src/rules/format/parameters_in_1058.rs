//! SPEC-21: I, J or K stands undeclared in an ISO 1058 detail.

use crate::format::Detail;
use crate::rules::is_declared_letter;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "parameter-in-positioning-format",
    title: "I, J or K stands undeclared in an ISO 1058 detail.",
    verdicts: Verdicts::positioning("SPEC-21", Severity::Error),
    clauses: &[Clause::Iso1058("B.1")],
    page: page!("SPEC-21"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if "IJK".contains(word.address) && !is_declared_letter(word.address, control) {
            let message =
                format!("{}: {} is unassigned in ISO 1058; declare what it means.", word.text(), word.address);
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
