//! WORD-03 / WORD-04: dimension words stand out of order.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "dimension-word-order",
    title: "Dimension words stand out of order.",
    verdicts: Verdicts::contouring("WORD-03", Severity::Error).and_iso1058("WORD-04", Severity::Warning),
    clauses: &[Clause::Both("3.2.2.2")],
    page: page!("WORD-03"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let mut highest: Option<(usize, &Word)> = None;
    for word in block.words {
        let Some(place) = place(word, block.control) else { continue };
        match highest {
            // What stands here a second time is said to be that: WORD-05.
            Some((before, _)) if place < before && super::repeated::is_repeated(word, block) => {}
            Some((before, other)) if place < before => {
                let order = match block.control.standard() {
                    Standard::Iso1058 => "X Y Z U V W P Q R A B C D E",
                    _ => "X Y Z U V W P Q R I J K A B C D E",
                };
                let message = format!(
                    "{} stands behind {}; dimension words run {order}. Move it forward.",
                    word.letter(),
                    other.letter()
                );
                sink.report(&RULE, word.range(), message).fixes(in_order(block));
                return;
            }
            _ => highest = Some((place, word)),
        }
    }
}

/// None where a feed word stands among them: it may belong to the word before it.
fn in_order(block: &BlockView<'_>) -> Option<Fix> {
    let words: Vec<&Word> = block.words.iter().filter(|word| place(word, block.control).is_some()).collect();
    let (first, last) = (words.first()?, words.last()?);
    let between = |word: &Word| (first.from..last.from).contains(&word.from) && word.address == b'F';
    if block.words.iter().any(between) {
        return None;
    }
    let mut ordered = words.clone();
    order_by_key(&mut ordered, |word| (place(word, block.control).unwrap_or(0), 0));
    reorder(&words, &ordered, block)
}

fn place(word: &Word, control: &Control) -> Option<usize> {
    let dimension = control.designation(word.address)?.dimension;
    let letters = crate::format::DIMENSION_LETTERS.bytes();
    dimension.then(|| letters.into_iter().position(|letter| letter == word.address))?
}
