//! CLD-15: a record has more than 245 elements.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "too-many-elements",
    title: "A record has more than 245 elements.",
    verdicts: Verdicts::cldata("CLD-15", Severity::Error),
    clauses: &[Clause::Iso3592("4")],
    page: page!("CLD-15"),
};

/// The most that a record may have.
const MOST: usize = 245;

pub(crate) fn check(record: &Record, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let count = record.elements().len();
    if count > MOST {
        let range = view.tables.of(record)[MOST].range();
        let message = format!(
            "The record has {count} elements; {MOST} are the most. This is the first beyond. A motion goes on in a \
             record \
             5000,6, other things in a record of their own."
        );
        sink.report(&RULE, range, message);
    }
}
