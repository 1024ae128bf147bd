//! CLD-20: a record stands behind the part program termination.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "record-behind-termination",
    title: "A record stands behind the part program termination.",
    verdicts: Verdicts::cldata("CLD-20", Severity::Error),
    clauses: &[Clause::Iso3592("6.1.3")],
    page: page!("CLD-20"),
};

pub(crate) fn check(view: &CldataView<'_>, sink: &mut Sink<'_>) {
    for records in view.tables.file_records() {
        let records = &view.tables.records[records];
        let Some(end) = records.iter().position(|record| record.kind == 14000) else { continue };
        if let Some(behind) = records.get(end + 1) {
            let message = "The part program termination is the last record of a file, and this one stands behind it. \
                           Move the \
                           termination to the end, or put a : between them if this begins another file.";
            sink.report(&RULE, view.place(behind), message.to_owned())
                .count(records.len() - end - 1)
                .related(view.place(&records[end]), "the termination");
        }
    }
}
