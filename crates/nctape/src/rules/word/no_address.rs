//! WORD-11: digits stand without an address.

use crate::format::power_of_ten;
use crate::function::{Preparatory, preparatory};
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
/// digits of both words, the last of an assigned function, in a block that moves and has no G.
pub(crate) fn run_in(word: &Word, block: &BlockView<'_>) -> Option<usize> {
    run_into_number(word, block.words, block.text, block.control)
}

/// The same of the words of a block and its text.
pub(crate) fn run_into_number(word: &Word, words: &[Word], text: &str, control: &Control) -> Option<usize> {
    if !word.is_sequence() && word.address != 0 {
        return None;
    }
    let (number, function) = (control.designation(b'N')?.width(), control.designation(b'G')?.width());
    let head = words.first().filter(|word| word.is_sequence() && control.system != System::Tab)?;
    let widths = u16::from(number) + u16::from(function);
    if (word.from, word.digits, word.fault) != (head.from, widths, NumberFault::None) {
        return None;
    }
    // A number such as N00010 is more probably a longer number.
    let (before, code) = (word.value? / power_of_ten(function), word.value? % power_of_ten(function));
    let assigned = matches!(preparatory(u8::try_from(code).ok()?), Preparatory::Assigned(..));
    let moves = |word: &Word| control.designation(word.address).is_some_and(|word| word.dimension);
    let has_function = words.iter().any(|word| word.address == b'G');
    if before == 0 || !assigned || has_function || !words.iter().any(moves) {
        return None;
    }
    let mut digits = text[word.range()].char_indices().filter(|(_, character)| character.is_ascii_digit());
    digits.nth(usize::from(number)).map(|(at, _)| word.range().start + at)
}
