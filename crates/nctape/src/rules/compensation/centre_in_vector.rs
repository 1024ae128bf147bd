//! COMP-04: P, Q and R give the centre of an arc.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "centre-in-vector",
    title: "P, Q and R give the centre of an arc.",
    verdicts: Verdicts::contouring("COMP-04", Severity::Warning),
    clauses: &[Clause::Iso2539("4.1.3"), Clause::Iso2539("5")],
    page: page!("COMP-04"),
};

/// Where the arc has no I, J and K, and P, Q and R in their place put its end on a circle.
pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::CentreInVector { own_reading } = event.kind else { return };
    let block = &tape.reading.blocks[event.block];
    let words = tape.reading.words(block);
    let vector = words.iter().filter(|word| matches!(word.address, b'P' | b'Q' | b'R'));
    // The same digits fit where the detail has the same designation for both letters.
    let alike = |letter: u8| {
        let of = |letter: u8| tape.control.designation(letter).map(|it| (it.before, it.after, it.sign));
        of(letter).is_some() && of(letter) == of(letter - b'P' + b'I')
    };
    let edits: Vec<_> = vector
        .clone()
        .map(|word| {
            let at = tape.range(block, word).start;
            (at..at + 1, char::from(word.address.wrapping_sub(b'P').wrapping_add(b'I')).to_string())
        })
        .collect();
    // Under another reading than the format's the same digits would be another centre.
    let fits = own_reading && vector.clone().all(|word| alike(word.address)) && words.iter().all(|word| word.tabs == 0);
    sink.report(
        &RULE,
        super::vector_words(tape, event.block),
        "The arc has no I, J and K; P, Q and R, read in their place, are its centre. They are not interpolation \
         parameters: write I, J and K."
            .to_owned(),
    )
    .fixes(fits.then(|| Fix::edits("Write I, J and K", edits)));
}
