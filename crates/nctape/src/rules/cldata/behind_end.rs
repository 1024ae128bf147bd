//! CLD-41: the tool moves after END.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-behind-end",
    title: "The tool moves after END.",
    verdicts: Verdicts::cldata("CLD-41", Severity::Warning),
    clauses: &[Clause::Iso3592("6.14")],
    page: page!("CLD-41"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::BehindEnd {
        let message = "END ends the machine program, and the tool moves after it. Put END behind the last motion.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
