//! SPEC-16: the detail gives N fewer than three digits.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "short-sequence-number-format",
    title: "The detail gives N fewer than three digits.",
    verdicts: Verdicts::contouring("SPEC-16", Severity::Error),
    clauses: &[Clause::Iso2539("3.3.4.1")],
    page: page!("SPEC-16"),
};

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if word.address == 'N' && word.digits.len() == 1 && word.before < 3 {
            let message = format!("{}: a sequence number has at least 3 digits.", word.text());
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
