//! WORD-01 / WORD-02: words stand out of order.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "word-order",
    title: "Words stand out of order.",
    verdicts: Verdicts::contouring("WORD-01", Severity::Error).and_iso1058("WORD-02", Severity::Warning),
    clauses: &[Clause::Both("3.2.2")],
    page: page!("WORD-01"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let mut highest: Option<(u8, &Word)> = None;
    for word in block.words {
        let Some(class) = class(word, block.control) else { continue };
        match highest {
            // What stands here a second time is said to be that: WORD-05.
            Some((before, _)) if class < before && super::repeated::is_repeated(word, block) => {}
            Some((before, other)) if class < before => {
                let message = format!(
                    "{} stands behind {}; the order is G, dimensions, F, S, T, M. Move it forward.",
                    word.letter(),
                    other.letter()
                );
                sink.report(&RULE, word.range(), message).fixes(in_order(block));
                return;
            }
            _ => highest = Some((class, word)),
        }
    }
}

fn in_order(block: &BlockView<'_>) -> Option<Fix> {
    let placed = |word: &&Word| class(word, block.control).is_some();
    let words: Vec<&Word> = block.words.iter().filter(placed).collect();
    let mut ordered = words.clone();
    order_by_key(&mut ordered, |word| (class(word, block.control).map_or(0, usize::from), 0));
    reorder(&words, &ordered, block)
}

/// The place of a word in the order; `None` where it has none. Among dimension words ISO 2539 lets feed words stand
/// too, and has rules of its own for them.
fn class(word: &Word, control: &Control) -> Option<u8> {
    let designation = control.designation(word.address)?;
    match word.address {
        b'G' => Some(1),
        _ if designation.dimension => Some(2),
        b'F' if control.standard() == Standard::Iso1058 => Some(3),
        b'F' => Some(2),
        b'S' => Some(4),
        b'T' => Some(5),
        b'M' => Some(6),
        _ => None,
    }
}
