//! CLD-39: a cycle has no depth.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "cycle-without-depth",
    title: "A cycle has no depth.",
    verdicts: Verdicts::cldata("CLD-39", Severity::Warning),
    clauses: &[Clause::Iso3592("6.14")],
    page: page!("CLD-39"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::CycleWithoutDepth {
        let message = "The cycle says nothing of how deep it goes. DEPTH and a real number say it, or FEDTO in some \
                       systems, or the number right behind the kind of cycle.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
