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
    if block.strays.is_empty() {
        return;
    }
    for word in block.words {
        let letters: Vec<(char, std::ops::Range<usize>)> = block
            .strays
            .iter()
            .filter_map(|stray| match stray.kind {
                StrayKind::LetterForDigit(letter) if is_it(letter) && word.range().contains(&stray.range().start) => {
                    Some((letter, stray.range()))
                }
                _ => None,
            })
            .collect();
        let (Some((letter, first)), Some((_, last))) = (letters.first(), letters.last()) else { continue };
        let message = format!(
            "The letter {letter} stands in the number of {}, where the digit {digit} is probably meant. Write the digit.",
            word.letter()
        );
        let fix = || {
            Fix::edits(
                format!("Write the digit {digit}"),
                letters.iter().map(|(_, range)| (range.clone(), digit.to_string())),
            )
        };
        sink.report(rule, first.start..last.end, message).count(letters.len()).fix(fix);
    }
}
