//! SEQ-03 / SEQ-04: the sequence number has a wrong count of digits.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-sequence-number-length",
    title: "The sequence number has a wrong count of digits.",
    verdicts: Verdicts::contouring("SEQ-03", Severity::Error).and_iso1058("SEQ-04", Severity::Error),
    clauses: &[Clause::Both("3.3.4.1")],
    page: page!("SEQ-03"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    // Digits that lost their address: WORD-11.
    let run_in = crate::rules::word::no_address::run_in(word, block).is_some();
    if is_wrong(word, block.control.standard()) && !run_in {
        let wanted = if block.control.standard() == Standard::Iso1058 { "exactly 3" } else { "at least 3" };
        let short = word.digits < 3;
        let message = format!(
            "{} has {}; a sequence number has {wanted}. {}",
            word.letter(),
            digits(word.digits),
            if short { "Fill it up with zeros in front, as N001." } else { "Number the blocks with 3." }
        );
        // Behind the address, which a T system does not punch.
        let at = word.range().start + usize::from(!word.by_column);
        let width = block.control.designation(b'N').map_or(3, |designation| u16::from(designation.width()).max(3));
        sink.report(&RULE, word.range(), message).fixes(short.then(|| {
            let zeros = "0".repeat(usize::from(width.saturating_sub(word.digits)));
            Fix::replace("Fill it up with zeros", at..at, zeros)
        }));
    }
}

/// The standard itself forbids the count of digits, whatever the format says.
pub(crate) fn is_wrong(word: &Word, standard: Standard) -> bool {
    word.is_sequence()
        && word.fault == NumberFault::None
        && if standard == Standard::Iso1058 { word.digits != 3 } else { word.digits < 3 }
}
