//! COMP-05: the cutter does not fit.

use crate::offset::FaultKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "cutter-too-large",
    title: "The cutter does not fit into the contour.",
    verdicts: Verdicts::contouring("COMP-05", Severity::Warning),
    clauses: &[Clause::Iso2539("5")],
    page: page!("COMP-05"),
};

/// Only where the format states the radius of the cutter, and compensation is in force.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let spans = &tape.execution.spans;
    let Some(path) = crate::tape::offset_of(tape.control, spans, f64::INFINITY) else { return };
    let cutter = tape.control.format.itemized.cutter_radius.map_or(0.0, |radius| radius.0);
    for fault in path.faults {
        let (severity, why) = match fault.kind {
            FaultKind::InsideArc { radius } => {
                let arc = match radius {
                    Some(radius) => format!("the radius of this inside arc, {radius:.3}"),
                    None => "that of the sharpest bend of this curve on the inside".to_owned(),
                };
                (Severity::Warning, format!("The radius of the cutter, {cutter}, is not smaller than {arc}"))
            }
            FaultKind::InsideCorner => {
                (Severity::Warning, format!("A cutter of radius {cutter} does not reach into the corner at the start of this span"))
            }
            FaultKind::TooShort => (
                Severity::Warning,
                format!("Between the inside corners at its ends a cutter of radius {cutter} leaves nothing of this span"),
            ),
            FaultKind::NotWorkedOut => (
                Severity::Info,
                "The path of the cutter\u{2019}s centre is not worked out here: it is for lines and arcs of the plane, and \
                 for parabolas without an inside corner"
                    .to_owned(),
            ),
        };
        let advice = match severity {
            Severity::Warning => {
                ". Take a smaller cutter, or change the contour; a control stops here, or cuts into it."
            }
            _ => ".",
        };
        let range = tape.extent(spans.list[fault.span].blocks.0);
        sink.report_as(severity, &RULE, range, format!("{why}{advice} The compensated path has a gap here."));
    }
}
