//! CLD-36: the circle lies in no principal plane.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tilted-circle",
    title: "The circle lies in no principal plane.",
    verdicts: Verdicts::cldata("CLD-36", Severity::Info),
    clauses: &[Clause::Iso3592("6.4")],
    page: page!("CLD-36"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::TiltedCircle {
        let message = "The axis of the circle is none of X, Y and Z, so that no control cuts it as an arc of a plane. \
                       The path goes from point to point.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
