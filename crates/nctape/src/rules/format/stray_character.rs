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

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for (character, range) in &detail.stray {
        let message = format!(
            "{character:?} has no meaning here; the detail has letters, signs, digits, full stops and one asterisk at its end."
        );
        sink.report(&RULE, range.clone(), message);
    }
}
