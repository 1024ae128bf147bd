//! CLD-16: the first two elements of a record are not both integers.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "head-not-integer",
    title: "The first two elements of a record are not both integers.",
    verdicts: Verdicts::cldata("CLD-16", Severity::Error),
    clauses: &[Clause::Iso3592("4"), Clause::Iso3592("5.15.1")],
    page: page!("CLD-16"),
};

pub(crate) fn check(record: &Record, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let elements = view.tables.of(record).iter().take(2).zip(["number", "type"]);
    for (element, what) in
        elements.filter(|(element, _)| !matches!(element.kind, ElementKind::Integer | ElementKind::Unreadable))
    {
        let message = format!(
            "The {what} of a record is an integer number, and {} is {}.",
            quoted(view.at(&element.range())),
            element.kind.name()
        );
        let fix =
            element.whole().map(|whole| Fix::replace("Write it as an integer", element.range(), whole.to_string()));
        sink.report(&RULE, element.range(), message).fixes(fix);
    }
}
