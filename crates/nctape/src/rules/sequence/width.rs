//! SEQ-05: the sequence number is not as long as the format says.
//!
//! ISO 1058 has three digits in every format: there it is SEQ-04.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "sequence-number-off-format",
    title: "The sequence number is not as long as the format says.",
    verdicts: Verdicts::contouring("SEQ-05", Severity::Error),
    clauses: &[Clause::Both("D.3.2")],
    page: page!("SEQ-05"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    // A colon stands in place of N and has its digits (B.1 note 2).
    let Some(designation) = block.control.designation(b'N') else { return };
    let wanted = u16::from(designation.width());
    let named = super::digits::is_wrong(word, block.control.standard());
    let named = named || crate::rules::word::no_address::run_in(word, block).is_some();
    if word.is_sequence() && word.fault == NumberFault::None && word.digits != wanted && !named {
        let message = format!(
            "{} has {}; this format wants {wanted} ({}). Write as many.",
            word.letter(),
            digits(word.digits),
            designation.text()
        );
        sink.report(&RULE, word.range(), message);
    }
}
