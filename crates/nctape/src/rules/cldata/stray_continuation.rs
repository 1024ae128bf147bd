//! CLD-32: a continuation has no motion to continue.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "stray-continuation",
    title: "A continuation has no motion to continue.",
    verdicts: Verdicts::cldata("CLD-32", Severity::Error),
    clauses: &[Clause::Iso3592("6.6")],
    page: page!("CLD-32"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::StrayContinuation {
        let range = view.place(&view.tables.records[found.record]);
        let subtype = view.tables.elements[view.tables.records[found.record].elements().start + 2].range();
        let message = "5000,6 goes on with the motion of the 5000,5 before it, and none stands there. It is read as a \
                       motion of its own: write 5.";
        sink.report(&RULE, range, message.to_owned()).fix(|| Fix::replace("Write 5", subtype, "5"));
    }
}
