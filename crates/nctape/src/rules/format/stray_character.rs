//! SPEC-25: the detail holds a character that has no meaning there.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "stray-character-in-format",
    title: "The detail holds a character that has no meaning there.",
    verdicts: Verdicts::all("SPEC-25", Severity::Error),
    clauses: &[Clause::Both("annex D")],
    page: page!("SPEC-25"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for range in &detail.stray {
        let message = format!(
            "{:?} has no meaning here; the detail has letters, digits, at most one of +, D and L before the digits of a \
             word, full stops before letters, and one asterisk at its end. Take it out.",
            &control.format.detail[range.clone()]
        );
        sink.report(&RULE, range.clone(), message);
    }
}
