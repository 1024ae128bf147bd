//! CLD-18: the type is not in the table of record types.

use super::prelude::*;
use crate::cldata::type_name;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unlisted-record-type",
    title: "The type is not in the table of record types.",
    verdicts: Verdicts::cldata("CLD-18", Severity::Error),
    clauses: &[Clause::Iso3592("4")],
    page: page!("CLD-18"),
};

pub(crate) fn check(record: &Record, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Some(element) = view.tables.of(record).get(1).filter(|element| element.kind == ElementKind::Integer) else {
        return;
    };
    if type_name(record.kind).is_some() {
        return;
    }
    let what = view.at(&element.range());
    let advice = match record.kind {
        10000 | 11000 | 12000 | 13000 => {
            "Older systems use it; the edition of 2000 does not have it. The record is kept, and nothing is made of it."
        }
        _ => {
            "The types are 1000 to 9000, 14000, 15000, 16000, 20000 and 21000, and 28000 to 32000 are everyone's own. \
             The record is kept, and nothing is made of it."
        }
    };
    sink.report(&RULE, element.range(), format!("{} is no record type of ISO 3592. {advice}", quoted(what)));
}
