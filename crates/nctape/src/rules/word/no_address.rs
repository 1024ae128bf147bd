//! WORD-11: digits stand without an address.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "digits-without-address",
    title: "Digits stand without an address.",
    verdicts: Verdicts::all("WORD-11", Severity::Error),
    clauses: &[Clause::Both("C.1.2")],
    page: page!("WORD-11"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if let Some(at) = run_in(word, block) {
        let message = format!(
            "The last digits of {} have no address: the sequence number has {} of them, and behind it the address G is \
             missing. Put it there.",
            &block.text[word.range()],
            block.control.designation(b'N').map_or(3, |number| number.width())
        );
        sink.report(&RULE, word.range(), message).fix(|| Fix::replace("Put G before them", at..at, " G"));
    }
    // In a T system this is a column too many: TAB-03.
    if word.address == 0 && block.control.system != System::Tab {
        sink.report(
            &RULE,
            word.range(),
            "The digits have no address; in a system with addresses every word begins with one. Put it before them."
                .to_owned(),
        );
    }
}

/// Where the digits of a preparatory function begin that lost its G and ran into the sequence number before it:
/// two digits too many, and no G in the block.
pub(crate) fn run_in(word: &Word, block: &BlockView<'_>) -> Option<usize> {
    let (number, function) = (block.control.designation(b'N')?, block.control.designation(b'G')?);
    let widths = u16::from(number.width()) + u16::from(function.width());
    let head = block.sequence()?;
    let lost = block.control.system != System::Tab
        && (word.from, word.digits, word.fault) == (head.from, widths, NumberFault::None)
        && !block.words.iter().any(|other| other.address == b'G');
    let digits = block.text[word.range()].char_indices().filter(|(_, character)| character.is_ascii_digit());
    let mut digits = digits.skip(usize::from(number.width())).filter(|_| lost);
    digits.next().map(|(at, _)| word.range().start + at)
}
