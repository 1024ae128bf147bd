//! WORD-10: an address has no digits.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "address-without-digits",
    title: "An address has no digits.",
    verdicts: Verdicts::all("WORD-10", Severity::Error),
    clauses: &[Clause::Both("3.3.2")],
    page: page!("WORD-10"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if word.fault != NumberFault::Empty || word.address == 0 || word.by_column {
        return;
    }
    // An O right behind it stands for a zero: WORD-14.
    let next = block.words.binary_search_by_key(&word.to, |other| other.from);
    let letter_o = next.is_ok_and(|next| block.words[next].address == b'O');
    if super::is_known(word, block.control) && !letter_o {
        let wanted = block.control.designation(word.address).map_or(String::new(), |designation| {
            format!(" It wants {} here ({}).", digits(u16::from(designation.width())), designation.text())
        });
        let message = format!("The address {} has no digits.{wanted} Write them, or take it out.", word.letter());
        sink.report(&RULE, word.range(), message);
    }
}
