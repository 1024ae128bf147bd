//! SPEC-09: the dimension words are not as many as the classification says.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-count-differs",
    title: "The dimension words are not as many as the classification says.",
    verdicts: Verdicts::all("SPEC-09", Severity::Warning).not_rs274(),
    clauses: &[Clause::Both("C.2.2")],
    page: page!("SPEC-09"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    // A word that could not be read may be the one that is missed.
    if !detail.stray.is_empty() {
        return;
    }
    let Some([_, stated, _]) = control.classification.as_ref().and_then(|found| found.digits()) else { return };
    let found = control.axes.iter().filter(|axis| axis.sign.is_some()).count();
    if found != usize::from(stated) {
        let message = format!(
            "The detail has {found} dimension words for motions; the second digit of the classification says {stated}."
        );
        sink.report(&RULE, 0..detail.length, message);
    }
}
