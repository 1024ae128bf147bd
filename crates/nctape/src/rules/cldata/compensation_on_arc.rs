//! CLD-38: cutter compensation changes on an arc.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "compensation-change-on-arc",
    title: "Cutter compensation changes on an arc.",
    verdicts: Verdicts::cldata("CLD-38", Severity::Warning),
    clauses: &[Clause::Iso3592("6.14")],
    page: page!("CLD-38"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::CompensationOnArc {
        let message = "CUTCOM stands between a circle and its motion, so that compensation would begin or end on the \
                       arc. Put it before a straight motion.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
