//! CLD-21: an integer stands where a real number belongs.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "integer-for-real",
    title: "An integer stands where a real number belongs.",
    verdicts: Verdicts::cldata("CLD-21", Severity::Error),
    clauses: &[Clause::Iso3592("5.10.1")],
    page: page!("CLD-21"),
};

pub(crate) fn check(view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let is = |found: &&Noted| matches!(found.event, Event::IntegerForReal { .. });
    let found: Vec<&Noted> = view.execution.events.iter().filter(is).collect();
    for group in found.chunk_by(|one, other| one.record == other.record) {
        let first = view.event(group[0]);
        let number = view.at(&first);
        let message =
            format!("{number} has no decimal point and is an integer number; here a real number belongs: {number}.");
        // Whether a command takes reals alone is known by the examples and by what systems write, not by its clause.
        let printed = matches!(group[0].event, Event::IntegerForReal { printed: true });
        let severity = if printed { Severity::Error } else { Severity::Warning };
        sink.report_as(severity, &RULE, first, message).count(group.len()).fix(|| {
            let title = if group.len() == 1 { "Put a point behind it" } else { "Put a point behind each" };
            let ends = group.iter().map(|found| view.event(found).end);
            Fix::edits(title, ends.map(|end| (end..end, ".".to_owned())))
        });
    }
}
