//! CLD-12: a record ends without its separator.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "missing-record-separator",
    title: "A record ends without its separator.",
    verdicts: Verdicts::cldata("CLD-12", Severity::Error),
    clauses: &[Clause::Iso3592("5.14.4"), Clause::Iso3592("5.15.1")],
    page: page!("CLD-12"),
};

pub(crate) fn check(found: &Slipped, _view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Slip::NoSemicolon { comma } = found.slip else { return };
    let end = found.range.end;
    let message = "A record ends with ; and a line end is none. What follows can only be the next record, or the end \
                   of the \
                   file, so the record is taken to end here. Put the ; in.";
    let edit = comma.map_or(end..end, |comma| comma..comma + 1);
    sink.report(&RULE, found.range.clone(), message.to_owned()).fix(|| Fix::replace("Put ; here", edit, ";"));
}
