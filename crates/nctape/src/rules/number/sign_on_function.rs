//! NUM-14: a word that is no dimension has a sign.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "sign-on-function",
    title: "A word that is no dimension has a sign.",
    verdicts: Verdicts::all("NUM-14", Severity::Error),
    clauses: &[Clause::Both("3.3.4")],
    page: page!("NUM-14"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let dimension = block.control.designation(word.address).is_none_or(|designation| designation.dimension);
    if word.sign.is_some() && (!dimension || word.is_sequence()) && word.fault == NumberFault::None {
        let message = format!("{} is no dimension word and has no sign. Leave it out.", word.letter());
        sink.report(&RULE, word.range(), message).fix(|| super::leave_sign_out(word, block));
    }
}
