//! CLD-13: a file ends without its separator.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "missing-file-separator",
    title: "A file ends without its separator.",
    verdicts: Verdicts::cldata("CLD-13", Severity::Error),
    clauses: &[Clause::Iso3592("5.16.1"), Clause::Iso3592("5.17.1")],
    page: page!("CLD-13"),
};

pub(crate) fn check(found: &Slipped, _view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.slip == Slip::NoColon {
        let end = found.range.end;
        let message = "A file ends with : behind its last record, also where no other file follows. Put it in.";
        sink.report(&RULE, found.range.clone(), message.to_owned()).fix(|| Fix::replace("Put : here", end..end, "\n:"));
    }
}
