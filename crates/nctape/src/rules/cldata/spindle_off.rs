//! CLD-30: the tool cuts while the spindle is off.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-with-spindle-off",
    title: "The tool cuts while the spindle is off.",
    verdicts: Verdicts::cldata("CLD-30", Severity::Warning),
    clauses: &[Clause::Iso3592("6.6")],
    page: page!("CLD-30"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if let Event::SpindleOff { count } = found.event {
        let message =
            "The tool moves at feed while the spindle is off. Put the SPINDL before it, or RAPID if it does not cut.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned()).count(count);
    }
}
