//! CLD-24: the coordinates make no whole number of points.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "incomplete-point",
    title: "The coordinates make no whole number of points.",
    verdicts: Verdicts::cldata("CLD-24", Severity::Error),
    clauses: &[Clause::Iso3592("6.6")],
    page: page!("CLD-24"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if let Event::IncompletePoint { values, size } = found.event {
        let message = format!(
            "The record has {values} coordinates; a point has {size} of them{}. Write the missing ones, or take the \
             ones \
             that are too many out.",
            if size == 6 { ", as MULTAX is on: the place and the tool axis" } else { "" }
        );
        sink.report(&RULE, view.event(found), message);
    }
}
