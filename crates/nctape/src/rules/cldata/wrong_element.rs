//! CLD-23: the record wants another element here.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "element-of-another-kind",
    title: "The record wants another element here.",
    verdicts: Verdicts::cldata("CLD-23", Severity::Error),
    clauses: &[Clause::Iso3592("6")],
    page: page!("CLD-23"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let record = &view.tables.records[found.record];
    let name = crate::cldata::type_name(record.kind).unwrap_or("record");
    let range = match found.element {
        Some(_) => view.event(found),
        None => view.place(record),
    };
    let message = match found.event {
        Event::Wrong { wanted } => {
            let kind = found.element.map_or("", |element| view.tables.elements[element].kind.name());
            format!(
                "{} is {kind}; in a record of type {} ({name}) {} belongs here.",
                quoted(view.at(&range)),
                record.kind,
                wanted.name()
            )
        }
        Event::Missing { wanted } => format!(
            "The record ends too early: {} belongs behind element {} of a record of type {} ({name}).",
            wanted.name(),
            record.elements().len(),
            record.kind
        ),
        Event::Extra => format!(
            "{} is one element more than a record of type {} ({name}) has. Take it out.",
            quoted(view.at(&range)),
            record.kind
        ),
        _ => return,
    };
    sink.report(&RULE, range, message);
}
