//! NUM-11 / NUM-10: an incremental word has no sign.

use crate::format::Sign;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "incremental-word-without-sign",
    title: "An incremental word has no sign.",
    verdicts: Verdicts::contouring("NUM-11", Severity::Warning).and_iso1058("NUM-10", Severity::Error),
    clauses: &[Clause::Both("3.3.3.4.3")],
    page: page!("NUM-11"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address).filter(|word| word.dimension) else { return };
    // Zero has no direction.
    if super::is_short_zero(word, designation) {
        return;
    }
    if designation.sign == Sign::Incremental && word.sign.is_none() && word.fault == NumberFault::None {
        let reading = match block.control.standard() {
            Standard::Iso1058 => "the sign is compulsory",
            _ => "it is read as plus",
        };
        let message = format!(
            "{} is incremental ({}) and has no sign: {reading}. Write + or -, for the direction of motion.",
            word.letter(),
            designation.text()
        );
        sink.report(&RULE, word.range(), message).fix(|| super::write_plus(word, block));
    }
}
