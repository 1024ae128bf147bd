//! WORD-05 / WORD-06: a word stands twice in its block.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "repeated-word",
    title: "A word stands twice in its block.",
    verdicts: Verdicts::contouring("WORD-05", Severity::Error).and_iso1058("WORD-06", Severity::Error),
    clauses: &[Clause::Both("3.2.2")],
    page: page!("WORD-05"),
};

/// The word stands in its block a second time, which is reported.
pub(crate) fn is_repeated(word: &Word, block: &BlockView<'_>) -> bool {
    let earlier = |other: &Word| other.from < word.from && other.address == word.address;
    counts(word, block.control) && block.words.iter().any(earlier)
}

/// The address of the word may stand in a block once.
fn counts(word: &Word, control: &Control) -> bool {
    let Some(designation) = control.designation(word.address) else { return false };
    match (control.standard(), word.address) {
        (_, b'N') => false,
        (Standard::Iso1058, _) => designation.dimension,
        // Feed and tool words may be several (3.2.2.3, 3.2.2.5); a second M has a rule of its own.
        (_, b'F' | b'T' | b'M') => false,
        _ => true,
    }
}

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let mut seen = 0_u128;
    let twice = block.words.iter().any(|word| {
        let bit = 1 << (word.address & 127);
        let before = seen;
        seen |= bit;
        before & bit != 0
    });
    if !twice {
        return;
    }
    let mut first_of: [Option<&Word>; 128] = [None; 128];
    for word in block.words {
        if !counts(word, block.control) {
            continue;
        }
        let slot = &mut first_of[usize::from(word.address) & 127];
        let Some(first) = *slot else {
            *slot = Some(word);
            continue;
        };
        let message = format!(
            "{} stands twice in this block; a data word may not be repeated. Take one out, or put it into a block of \
             its own.",
            word.letter()
        );
        sink.report(&RULE, word.range(), message).related(first.range(), "the first one");
    }
}
