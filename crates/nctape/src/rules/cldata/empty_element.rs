//! CLD-09: there is nothing between two separators.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "empty-element",
    title: "There is nothing between two separators.",
    verdicts: Verdicts::cldata("CLD-09", Severity::Error),
    clauses: &[Clause::Iso3592("5.12.1"), Clause::Iso3592("5.13.1")],
    page: page!("CLD-09"),
};

pub(crate) fn check(found: &Slipped, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if !matches!(found.slip, Slip::Empty | Slip::Idle) {
        return;
    }
    let separator = view.at(&found.range);
    let what = match (&found.slip, separator) {
        (Slip::Empty, _) => {
            "There is no element before this separator. Write the element, . for zero or '' for an empty literal, or \
             take the separator out"
        }
        (_, ":") => "There is no record before this file separator. Take it out",
        _ => "There is no record before this record separator. Take it out",
    };
    sink.report(&RULE, found.range.clone(), format!("{what}."))
        .fixes((found.slip == Slip::Idle).then(|| Fix::replace("Take it out", found.range.clone(), "")));
}
