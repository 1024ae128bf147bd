//! CLD-29: the tool cuts before any feed is given.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-before-feed",
    title: "The tool cuts before any feed is given.",
    verdicts: Verdicts::cldata("CLD-29", Severity::Warning),
    clauses: &[Clause::Iso3592("6.6")],
    page: page!("CLD-29"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if let Event::NoFeed { count } = found.event {
        let message = "The tool moves at feed, and no FEDRAT has said how fast. Its time is not known. Put a FEDRAT \
                       before it, or RAPID if it is to be rapid.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned()).count(count);
    }
}
