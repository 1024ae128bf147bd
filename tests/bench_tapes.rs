//! The tapes that `cargo bench` measures are what they claim to be: a comparison rests on that.

#[path = "../crates/nctape/benches/tape/peers.rs"]
mod peers;
#[path = "../crates/nctape/benches/tape/tapes.rs"]
mod tapes;

use nctape::span::SpanKind;
use nctape::{Severity, Tape};
use std::collections::BTreeSet;

#[test]
fn the_contour_is_clean_and_every_block_of_it_cuts() {
    for blocks in [1, 10, 1000] {
        let tape = Tape::new(&tapes::contour(blocks).tape, &tapes::format());
        let found: Vec<_> = tape.diagnostics().into_iter().filter(|found| found.severity > Severity::Info).collect();
        assert!(found.is_empty(), "{found:?}");
        assert_eq!(tape.reading().blocks.len(), blocks);
        assert_eq!(tape.spans().list.len(), blocks);
        assert!(tape.totals().seconds.is_some());
    }
}

/// They are given the same program, and read all of it.
#[test]
fn the_peers_read_the_same_words() {
    let contour = tapes::contour(1000);
    let tape = Tape::new(&contour.tape, &tapes::format());
    let words = tape.reading().word_count();
    assert_eq!(words, 6 * 1000 + 1);
    assert_eq!(peers::nom_gcode(&contour.decimal), (1000, words));
    assert_eq!(peers::gcode_tree(&contour.decimal), (1000, words));
    assert_eq!(peers::gcode_visited(&contour.decimal), (1000, words));
    // One of them reads numbers into f32, so the values are compared as far as that goes.
    let ends = peers::gcode_x(&contour.decimal);
    for (index, x) in ends.into_iter().enumerate() {
        assert!((f64::from(x) - tape.spans().end(index)[0]).abs() < 1e-4, "block {index}");
    }
}

#[test]
fn one_block_of_a_hundred_of_the_mixed_tape_is_faulty() {
    let text = tapes::mixed(3000);
    let tape = Tape::new(&text, &tapes::format());
    let found: Vec<_> = tape.diagnostics().into_iter().filter(|found| found.severity > Severity::Info).collect();
    let blocks: BTreeSet<_> = found.iter().filter_map(|found| tape.reading().block_at(found.range.start)).collect();
    assert_eq!(blocks, (0..30).map(|hundred| 100 * hundred + 49).collect());
    let rules: BTreeSet<_> =
        found.iter().filter(|found| found.severity == Severity::Error).map(|found| found.id).collect();
    assert_eq!(rules.len(), 6, "{rules:?}");
    let count = |kind| tape.spans().list.iter().filter(|span| span.kind == kind).count();
    assert_eq!((count(SpanKind::Arc), count(SpanKind::Parabola)), (300, 300));
    assert_eq!(tape.spans().list.len(), 3000);
    assert_eq!(text.matches('(').count(), 300);
}

#[test]
fn the_awkward_tapes_are_as_large_as_they_say() {
    for awkward in tapes::AWKWARD {
        let tape = Tape::new(&(awkward.make)(50), &tapes::format());
        assert!(!tape.diagnostics().is_empty(), "{}", awkward.name);
        let blocks = tape.reading().blocks.len();
        assert!(matches!(blocks, 1 | 50), "{}: {blocks}", awkward.name);
        // Small enough, and one that grows with the square would not be seen.
        assert!(awkward.most >= 10_000, "{}", awkward.name);
    }
}
