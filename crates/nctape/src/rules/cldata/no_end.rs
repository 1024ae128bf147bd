//! CLD-40: a file that moves the tool has no END.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "no-end-command",
    title: "A file that moves the tool has no END.",
    verdicts: Verdicts::cldata("CLD-40", Severity::Info),
    clauses: &[Clause::Iso3592("6.14")],
    page: page!("CLD-40"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::NoEnd {
        let message = "No END stops the spindle and the coolant and rewinds the tape. The part program termination, \
                       type 14000, ends the file alone; some systems have their post processor end the machine program \
                       there.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
