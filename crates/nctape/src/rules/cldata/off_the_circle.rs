//! CLD-34: the ends of a motion are not on its circle.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "end-off-the-surface-circle",
    title: "The ends of a motion are not on its circle.",
    verdicts: Verdicts::cldata("CLD-34", Severity::Warning),
    clauses: &[Clause::Iso3592("6.4"), Clause::Iso3592("6.6")],
    page: page!("CLD-34"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Event::OffTheCircle { start, end, radius, cutter } = found.event else { return };
    let beside = match cutter {
        Some(cutter) if cutter > 0.0 => format!(", or half the cutter of {} beside it", shown(cutter)),
        _ => String::new(),
    };
    let message = format!(
        "The motion begins {} from the centre and ends {} from it; the circle has the radius {}. Both ends must be on \
         the \
         circle{beside}. The path is drawn from point to point.",
        shown(start),
        shown(end),
        shown(radius)
    );
    sink.report(&RULE, view.place(&view.tables.records[found.record]), message);
}
