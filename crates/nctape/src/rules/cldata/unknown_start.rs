//! CLD-28: nothing says where the tool stands before the first motion.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "start-not-known",
    title: "Nothing says where the tool stands before the first motion.",
    verdicts: Verdicts::cldata("CLD-28", Severity::Error),
    clauses: &[Clause::Iso3592("6.6")],
    page: page!("CLD-28"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Event::UnknownStart { needed } = found.event else { return };
    let (severity, message) = match needed {
        false => (
            Severity::Info,
            "Nothing says where the tool stands: the path begins at this point. FROM, a record 5000,3, says it.",
        ),
        true => (
            Severity::Error,
            "This motion goes by the place where the tool stands, and nothing says where that is: differences are \
             counted from zero, and an arc is left out. Put a FROM, a record 5000,3, before it.",
        ),
    };
    sink.report_as(severity, &RULE, view.place(&view.tables.records[found.record]), message.to_owned());
}
