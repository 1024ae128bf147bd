//! NUM-07: a designation lets leading and trailing zeros be left out.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "zeros-left-out-both-ways",
    title: "A designation lets leading and trailing zeros be left out.",
    verdicts: Verdicts::all("NUM-07", Severity::Error),
    clauses: &[Clause::Both("3.3.1"), Clause::Both("D.3.1")],
    page: page!("NUM-07"),
};

/// Tells whether a designation of four digits says so, by a zero at both ends.
pub(crate) fn holds(digits: &str) -> bool {
    digits.len() == 4 && digits.starts_with('0') && digits.ends_with('0')
}

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        if word.dimension && holds(&word.digits) {
            let message = format!(
                "{} lets leading and trailing zeros be left out; then the digits that are left have no place. Write the 0 on \
                 one side only.",
                word.text()
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}
