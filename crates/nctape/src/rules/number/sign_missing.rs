//! NUM-08: a signed absolute word has no sign.

use crate::format::Sign;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "missing-sign",
    title: "A signed absolute word has no sign.",
    verdicts: Verdicts::positioning("NUM-08", Severity::Error),
    clauses: &[Clause::Iso1058("3.3.3.4.1")],
    page: page!("NUM-08"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(designation) = block.control.designation(word.address).filter(|word| word.dimension) else { return };
    // One zero says zero, whatever its sign.
    if super::is_short_zero(word, designation) {
        return;
    }
    if designation.sign == Sign::Signed && word.sign.is_none() && word.fault == NumberFault::None {
        let message = format!(
            "{} has no sign; in ISO 1058 the sign is part of the word ({}). Write + or -.",
            word.letter(),
            designation.text()
        );
        sink.report(&RULE, word.range(), message).fix(|| super::write_plus(word, block));
    }
}
