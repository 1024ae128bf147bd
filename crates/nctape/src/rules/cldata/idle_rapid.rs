//! CLD-31: no motion follows a RAPID.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "idle-rapid",
    title: "No motion follows a RAPID.",
    verdicts: Verdicts::cldata("CLD-31", Severity::Warning),
    clauses: &[Clause::Iso3592("6.14")],
    page: page!("CLD-31"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::IdleRapid {
        let message = "RAPID is for the next motion alone, and none follows before another RAPID or the end of the \
                       file. Take it out, or put the motion behind it.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
