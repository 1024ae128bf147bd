//! NUM-12: a sign stands where only positive dimensions exist.

use crate::format::Sign;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "sign-on-positive-dimension",
    title: "A sign stands where only positive dimensions exist.",
    verdicts: Verdicts::all("NUM-12", Severity::Error),
    clauses: &[Clause::Both("3.3.3.4.2")],
    page: page!("NUM-12"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address).filter(|word| word.dimension) else { return };
    if let (Sign::Positive, Some(sign), NumberFault::None) = (designation.sign, word.sign, word.fault) {
        let message = format!(
            "{} has the sign {}; in this format the dimension is always positive and has none ({}). Leave it out.",
            word.letter(),
            char::from(sign),
            designation.text()
        );
        let reported = sink.report(&RULE, word.range(), message);
        // What a minus was meant to say is not known.
        if sign == b'+' {
            reported.fix(|| super::leave_sign_out(word, block));
        }
    }
}
