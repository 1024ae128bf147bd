//! CLD-19: a file has no part program termination.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "no-termination-record",
    title: "A file has no part program termination.",
    verdicts: Verdicts::cldata("CLD-19", Severity::Warning),
    clauses: &[Clause::Iso3592("6.11")],
    page: page!("CLD-19"),
};

pub(crate) fn check(view: &CldataView<'_>, sink: &mut Sink<'_>) {
    for records in view.tables.file_records() {
        let records = &view.tables.records[records];
        let Some(last) = records.last().filter(|_| records.iter().all(|record| record.kind != 14000)) else { continue };
        let message = "The file ends without a part program termination, type 14000: nothing says that it is whole. \
                       Put it \
                       behind the last record.";
        let range = view.place(last);
        let fix = view.number(last).filter(|_| view.at(&range).ends_with(';')).map(|(number, _)| {
            Fix::replace("Put it in", range.end..range.end, format!("\n{},14000;", number.saturating_add(1)))
        });
        sink.report(&RULE, range, message.to_owned()).fixes(fix);
    }
}
