//! CLD-37: a tool is changed while the spindle turns.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tool-change-with-spindle-on",
    title: "A tool is changed while the spindle turns.",
    verdicts: Verdicts::cldata("CLD-37", Severity::Warning),
    clauses: &[Clause::Iso3592("6.14")],
    page: page!("CLD-37"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::ToolWithSpindle {
        let message = "LOADTL changes the tool while the spindle is on. Put SPINDL,OFF before it, unless the post \
                       processor does so.";
        sink.report(&RULE, view.place(&view.tables.records[found.record]), message.to_owned());
    }
}
