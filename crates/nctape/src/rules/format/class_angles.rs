//! SPEC-05: the fourth letter of the classification is not R or D.

use crate::format::Classification;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unknown-angular-unit",
    title: "The fourth letter of the classification is not R or D.",
    verdicts: Verdicts::all("SPEC-05", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("C.1.4")],
    page: page!("SPEC-05"),
};

pub(crate) fn check(found: &Classification, sink: &mut Sink<'_>) {
    if found.letters.len() > 3 {
        super::check_letter(&RULE, found, 3, &[('R', "parts of a turn"), ('D', "degrees")], sink);
    }
    if let Some((letter, range)) = found.letters.get(4) {
        let message = format!("The classification has at most four letters; {letter} is one too many. Take it out.");
        sink.report(&RULE, range.clone(), message);
    }
}
