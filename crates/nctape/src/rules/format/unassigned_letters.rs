//! SPEC-20: H, L or O stands in the detail.

use crate::format::Detail;
use crate::rules::is_declared_letter;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unassigned-letter-in-format",
    title: "H, L or O stands in the detail.",
    verdicts: Verdicts::all("SPEC-20", Severity::Error),
    clauses: &[Clause::Both("B.1")],
    page: page!("SPEC-20"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if "HLO".contains(word.address) && (word.address == 'O' || !is_declared_letter(word.address, control)) {
            let message = format!(
                "{}: {} is {}.",
                word.text(),
                word.address,
                if word.address == 'O' { "not to be used" } else { "permanently unassigned; declare what it means" }
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
