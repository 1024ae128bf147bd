//! SPEC-26: the detail names no word.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "empty-detail",
    title: "The detail names no word.",
    verdicts: Verdicts::all("SPEC-26", Severity::Error),
    clauses: &[Clause::Both("annex D")],
    page: page!("SPEC-26"),
};

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    if detail.words.is_empty() {
        sink.report(
            &RULE,
            0..detail.length,
            "The detail names no word, so nothing on the tape can be read. Write one, such as N3.G2.X+42.Y+32.F4.M2*."
                .to_owned(),
        );
    }
}
