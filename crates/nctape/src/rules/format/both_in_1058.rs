//! SPEC-19: iSO 1058 has no L.

use crate::format::Detail;
use crate::format::Sign;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "l-in-positioning-format",
    title: "ISO 1058 has no L.",
    verdicts: Verdicts::positioning("SPEC-19", Severity::Error),
    clauses: &[Clause::Iso1058("D.3.1")],
    page: page!("SPEC-19"),
};

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if word.sign == Sign::Both {
            let message = format!(
                "{}: L, for absolute and incremental dimensions, is of ISO 2539; ISO 1058 has +, D or nothing.",
                word.text()
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
