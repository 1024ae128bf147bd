//! NUM-13: a sign does not stand before the first digit.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "misplaced-sign",
    title: "A sign does not stand before the first digit.",
    verdicts: Verdicts::all("NUM-13", Severity::Error),
    clauses: &[Clause::Both("3.3.3.4")],
    page: page!("NUM-13"),
};

pub(crate) fn check(word: &Word, _: &BlockView<'_>, sink: &mut Sink<'_>) {
    if let NumberFault::SignInside(at) = word.fault {
        let at = at as usize;
        let message = format!(
            "{} has a sign in the wrong place; it stands once, directly before the first digit.",
            word.letter()
        );
        sink.report(&RULE, at..at + 1, message);
    }
}
