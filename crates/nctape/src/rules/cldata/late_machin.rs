//! CLD-42: MACHIN stands behind other commands.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "late-machin",
    title: "MACHIN stands behind other commands.",
    verdicts: Verdicts::cldata("CLD-42", Severity::Warning),
    clauses: &[Clause::Iso3592("6.14")],
    page: page!("CLD-42"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::LateMachin {
        let message = "MACHIN says which post processor is meant, and other commands stand before it. Put it before \
                       them all; only PARTNO, PPRINT and UNITS may come first.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
