//! CLD-44: no record says the unit.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unit-not-said",
    title: "No record says the unit.",
    verdicts: Verdicts::cldata("CLD-44", Severity::Info),
    clauses: &[Clause::Iso3592("6.10")],
    page: page!("CLD-44"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::AssumedUnit {
        let message = "No record says the unit of lengths; millimetres are assumed. A record 9000,9 says it: 1 \
                       millimetre, 2 centimetre, 3 inch, 4 foot.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
