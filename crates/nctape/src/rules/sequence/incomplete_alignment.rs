//! SEQ-11: the block of an alignment function does not state all that is needed to begin.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "incomplete-alignment-block",
    title: "The block of an alignment function does not state all that is needed to begin.",
    verdicts: Verdicts::all("SEQ-11", Severity::Warning),
    clauses: &[Clause::Both("B.1 note 2")],
    page: page!("SEQ-11"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if !tape.seen.any(Traits::address(b':')) {
        return;
    }
    let control = tape.control;
    let blocks = &tape.reading.blocks;
    let has = |index: usize, letter: char| {
        blocks.get(index).is_some_and(|block| block.traits.any(Traits::address(letter as u8)))
    };
    for (index, block) in blocks.iter().enumerate() {
        if !block.traits.any(Traits::address(b':')) {
            continue;
        }
        let Some(word) = tape.reading.words(block).first().filter(|word| word.address == b':') else { continue };
        // What the tape never uses is not missed: no T without a tool changer.
        let is_used = |letter: char| tape.seen.any(Traits::address(letter as u8));
        let functions = "GFSTM".chars().filter(|&letter| {
            let known = control.designation(letter as u8).is_some();
            known && (is_used(letter) || letter == 'G') && !has(index, letter)
        });
        let axes = control.axes.iter().filter(|axis| axis.sign.is_some()).map(|axis| axis.letter);
        let axes = axes.filter(|&axis| is_used(axis) && !has(index, axis) && !has(index + 1, axis));
        let mut missing: Vec<char> = functions.chain(axes).collect();
        // In the order in which they are to be written.
        let place = |letter: char| control.detail.words.iter().position(|word| word.address == letter);
        order_by_key(&mut missing, |&letter| (place(letter).map_or(0, |place| place + 1), 0));
        let missing: Vec<String> = missing.into_iter().map(String::from).collect();
        if missing.is_empty() {
            continue;
        }
        let message = format!(
            "The alignment function begins a part that can be started on its own, but {} {} not stated again in its \
             block. Add them, or use N.",
            missing.join(", "),
            if missing.len() == 1 { "is" } else { "are" }
        );
        sink.report(&RULE, tape.range(block, word), message);
    }
}
