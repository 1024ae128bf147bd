//! CLD-35: the way round a circle is in doubt.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "doubtful-direction",
    title: "The way round a circle is in doubt.",
    verdicts: Verdicts::cldata("CLD-35", Severity::Warning),
    clauses: &[Clause::Iso3592("6.4"), Clause::Iso3592("6.6")],
    page: page!("CLD-35"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if let Event::DoubtfulDirection { degrees } = found.event {
        let message = format!(
            "By its axis the motion goes {} degrees round the circle, and it has no point on the way that would bear \
             this \
             out. Where the system that wrote the file gives every axis as positive, it may be the other way. Put a point on \
             the way.",
            shown(degrees)
        );
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message);
    }
}
