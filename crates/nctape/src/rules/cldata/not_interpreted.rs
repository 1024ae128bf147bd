//! CLD-26: the record is kept, and nothing is made of it.

use super::prelude::*;
use crate::cldata::type_name;

/// The rule.
pub static RULE: Rule = Rule {
    name: "not-interpreted",
    title: "The record is kept, and nothing is made of it.",
    verdicts: Verdicts::cldata("CLD-26", Severity::Warning),
    clauses: &[Clause::Iso3592("4")],
    page: page!("CLD-26"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Event::NotInterpreted(what) = found.event else { return };
    let message = match what {
        Uninterpreted::Type(15000) => "An unsegmented tool path is kept, but what its elements mean is not public: \
                                       this part of the path is not drawn."
            .to_owned(),
        Uninterpreted::Type(kind) => format!(
            "Records of type {kind} ({}) are kept, and nothing is made of them: they do not bear on the path.",
            type_name(kind).unwrap_or_default()
        ),
        Uninterpreted::Subtype(kind, subtype) => format!(
            "Records {kind},{subtype} are kept, and nothing is made of \
                                                          them: they do not bear on the path."
        ),
        Uninterpreted::Command(word) => match word.word().as_str() {
            "CYCLE" => "A cycle is kept, but its strokes are not drawn: the path goes from hole to hole at rapid \
             traverse."
                .to_owned(),
            "INSERT" => "INSERT goes to the tape as it is. What it makes the machine do is not drawn.".to_owned(),
            "CUTCOM" => "The control moves the path by the cutter compensation; it is drawn as it is \
             programmed."
                .to_owned(),
            word => format!(
                "{word} is kept, but its bearing on the path is not drawn: some systems have carried it \
                             out already when they write the points, others leave it to the post processor."
            ),
        },
    };
    let severity = if what == Uninterpreted::Type(15000) { Severity::Warning } else { Severity::Info };
    sink.report_as(severity, &RULE, view.event(found), message);
}
