//! CLD-25: the subtype is not known.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unlisted-subtype",
    title: "The subtype is not known.",
    verdicts: Verdicts::cldata("CLD-25", Severity::Warning),
    clauses: &[
        Clause::Iso3592("6.4"),
        Clause::Iso3592("6.5"),
        Clause::Iso3592("6.6"),
        Clause::Iso3592("6.7"),
        Clause::Iso3592("6.8"),
        Clause::Iso3592("6.9"),
        Clause::Iso3592("6.10"),
    ],
    page: page!("CLD-25"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::UnlistedSubtype {
        let range = view.event(found);
        let message = format!(
            "{} is not known as a subtype, or as a code, in a record of type {}. The record is kept, and nothing is \
             made of it.",
            quoted(view.at(&range)),
            view.tables.records[found.record].kind
        );
        sink.report(&RULE, range, message);
    }
}
