//! CLD-43: the unit changes midway.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "changed-unit",
    title: "The unit changes midway.",
    verdicts: Verdicts::cldata("CLD-43", Severity::Warning),
    clauses: &[Clause::Iso3592("6.10")],
    page: page!("CLD-43"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::ChangedUnit {
        let message = "The unit of lengths is said anew behind a motion, or differs from the one before. Points from \
                       here on are turned into the first unit. Say the unit once, at the start.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
