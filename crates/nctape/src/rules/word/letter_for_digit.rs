//! WORD-23: an I or L stands in a number.

use crate::read::StrayKind;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "letter-for-digit",
    title: "A letter stands in a number for the digit that it looks like.",
    verdicts: Verdicts::all("WORD-23", Severity::Error),
    clauses: &[Clause::Both("3.3.2")],
    page: page!("WORD-23"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    report(&RULE, |letter| matches!(letter, 'I' | 'i' | 'L' | 'l'), '1', block, sink);
}

/// Reports the letters of each number that are taken for a digit: one finding for a word.
pub(super) fn report(
    rule: &'static Rule,
    is_it: impl Fn(char) -> bool,
    digit: char,
    block: &BlockView<'_>,
    sink: &mut Sink<'_>,
) {
    let letters = block.strays.iter().filter_map(|stray| match stray.kind {
        StrayKind::LetterForDigit(letter) if is_it(letter) => {
            Some((block.word_at(stray.range().start)?, letter, stray.range()))
        }
        _ => None,
    });
    let letters: Vec<_> = letters.collect();
    for letters in letters.chunk_by(|one, next| std::ptr::eq(one.0, next.0)) {
        let [(word, letter, first), ..] = letters else { continue };
        let last = letters.last().map_or(first, |(.., last)| last);
        let message = format!(
            "The letter {letter} stands in the number of {}, where the digit {digit} is probably meant. Write the digit.",
            word.letter()
        );
        let fix = || {
            Fix::edits(
                format!("Write the digit {digit}"),
                letters.iter().map(|(.., range)| (range.clone(), digit.to_string())),
            )
        };
        sink.report(rule, first.start..last.end, message).count(letters.len()).fix(fix);
    }
}
