//! CLD-14: a record has less than two elements.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "too-few-elements",
    title: "A record has less than two elements.",
    verdicts: Verdicts::cldata("CLD-14", Severity::Error),
    clauses: &[Clause::Iso3592("5.15.1")],
    page: page!("CLD-14"),
};

pub(crate) fn check(record: &Record, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if record.elements().len() < 2 {
        let message =
            "A record has two elements at least: its number and its type. Write them, or take the record out.";
        sink.report(&RULE, view.place(record), message.to_owned());
    }
}
