//! NUM-15: a word says minus zero.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "minus-zero",
    title: "A word says minus zero.",
    verdicts: Verdicts::all("NUM-15", Severity::Info),
    clauses: &[Clause::Both("3.3.3.4")],
    page: page!("NUM-15"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let dimension = block.control.designation(word.address).is_some_and(|designation| designation.dimension);
    if dimension && word.sign == Some(b'-') && word.value == Some(0) {
        let message = format!("{} says minus zero, which is zero. Printed examples have it too.", word.letter());
        sink.report(&RULE, word.range(), message);
    }
}
