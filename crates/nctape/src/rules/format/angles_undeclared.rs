//! SPEC-08: an angular dimension word stands without R or D in the classification.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "angular-unit-not-stated",
    title: "An angular dimension word stands without R or D in the classification.",
    verdicts: Verdicts::all("SPEC-08", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("C.1.4"), Clause::Both("D.3.1")],
    page: page!("SPEC-08"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if word.dimension
            && "ABC".contains(word.address)
            && control.classification.as_ref().is_some_and(|found| found.angles().is_none())
        {
            let message = format!(
                "{} is an angular dimension; the classification must say R (turns) or D (degrees) as its fourth letter.",
                word.text()
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
