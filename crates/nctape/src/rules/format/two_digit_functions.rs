//! SPEC-18: G and M have two digits.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "function-format-not-two",
    title: "G and M have two digits.",
    verdicts: Verdicts::all("SPEC-18", Severity::Error),
    clauses: &[Clause::Both("3.3.4.2"), Clause::Both("3.3.4.6")],
    page: page!("SPEC-18"),
};

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if matches!(word.address, 'G' | 'M') && word.digits.len() == 1 && word.before != 2 {
            let message = format!("{}: {} has exactly two digits ({}2).", word.text(), word.address, word.address);
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
