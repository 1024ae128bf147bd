//! CLD-22: a real number stands where an integer belongs.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "real-for-integer",
    title: "A real number stands where an integer belongs.",
    verdicts: Verdicts::cldata("CLD-22", Severity::Error),
    clauses: &[Clause::Iso3592("5.9.1")],
    page: page!("CLD-22"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event != Event::RealForInteger {
        return;
    }
    let range = view.event(found);
    let whole = found.element.and_then(|element| view.tables.elements[element].whole());
    let message = format!(
        "{} has a decimal point and is a real number; here an integer number belongs.",
        quoted(view.at(&range))
    );
    let fix = whole.map(|whole| Fix::replace(format!("Write {whole}"), range.clone(), whole.to_string()));
    sink.report(&RULE, range, message).fixes(fix);
}
