//! SEQ-03 / SEQ-04: the sequence number has too few digits.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-sequence-number-length",
    title: "The sequence number has too few digits.",
    verdicts: Verdicts::contouring("SEQ-03", Severity::Error).and_iso1058("SEQ-04", Severity::Error),
    clauses: &[Clause::Both("3.3.4.1")],
    page: page!("SEQ-03"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if is_wrong(word, block.control.standard()) {
        let wanted = if block.control.standard() == Standard::Iso1058 { "exactly 3" } else { "at least 3" };
        let message = format!(
            "{} has {}; a sequence number has {wanted}. Fill it up with zeros in front, as N001.",
            word.letter(),
            digits(word.digits)
        );
        sink.report(&RULE, word.range(), message);
    }
}

/// The standard itself forbids the count of digits, whatever the format says.
pub(crate) fn is_wrong(word: &Word, standard: Standard) -> bool {
    word.is_sequence()
        && word.fault == NumberFault::None
        && if standard == Standard::Iso1058 { word.digits != 3 } else { word.digits < 3 }
}
