//! CLD-33: no motion follows the circle of a surface record.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "idle-surface",
    title: "No motion follows the circle of a surface record.",
    verdicts: Verdicts::cldata("CLD-33", Severity::Warning),
    clauses: &[Clause::Iso3592("6.4")],
    page: page!("CLD-33"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::IdleSurface {
        let message = "The circle is that of the next motion, and none follows before another circle or the end of the \
                       file. Take it out, or put the motion behind it.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
