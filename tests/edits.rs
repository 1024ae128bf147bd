//! An edited tape is what a fresh one is, and little of it is read again.

#[path = "support/edits.rs"]
mod edits;

use edits::{dump, edited, formats, tape};
use nctape::Tape;

#[test]
fn after_each_of_a_thousand_edits_a_tape_equals_a_fresh_one() {
    for seed in 0..20 {
        edited(seed, 50, &tape(30));
    }
}

#[test]
fn so_does_a_long_tape_whose_blocks_a_comment_swallows_and_gives_back() {
    for seed in 100..104 {
        edited(seed, 50, &tape(300));
    }
}

#[test]
fn so_does_one_that_is_executed_from_a_mark_on() {
    // What is known of the spans between two marks is joined for this rule.
    assert!(formats().iter().any(|format| dump(&Tape::new(&tape(1_500), format)).contains("FEED-15")));
    for seed in 200..204 {
        edited(seed, 25, &tape(1_500));
    }
}

#[test]
fn whether_the_text_begins_with_a_label_may_hang_on_what_stands_far_behind_it() {
    let text = "PLATE\nSIDE A (B)\n\nFACE C\n%\nN001 G00 X+001000\nN002 M30\n";
    let mut tape = Tape::new(text, &formats()[0]);
    for at in 0..text.len() {
        for (removed, insert) in [(1, ""), (0, "%"), (0, "\n"), (0, "N5 "), (0, "("), (0, ")"), (0, "AB")] {
            tape.edit(at..at + removed, insert);
            let fresh = Tape::new(tape.text(), &formats()[0]);
            assert_eq!(dump(&tape), dump(&fresh), "{:?}", tape.text());
            tape.edit(at..at + insert.len(), &text[at..at + removed]);
            assert_eq!(tape.text(), text);
            assert_eq!(dump(&tape), dump(&Tape::new(text, &formats()[0])), "back from {at}, {insert:?}");
        }
    }
}

#[test]
fn the_rows_of_a_stretch_are_those_of_the_whole() {
    let tape = Tape::new(&tape(40), &formats()[0]);
    let rows = tape.rows();
    for first in 0..rows.bytes.len() {
        let some = tape.rows_from(first, 7);
        let last = (first + 7).min(rows.bytes.len());
        assert_eq!((&some.bytes[..], &some.offsets[..]), (&rows.bytes[first..last], &rows.offsets[first..last]));
        let offset = rows.offsets[first] as usize;
        assert_eq!(tape.row_at(offset), first);
        assert_eq!(tape.reading().block_of_row(first), tape.reading().block_at(offset), "row {first}");
    }
}

const LINE: &str = "N001 G01 X+001000 Y+001000 F0300\n";

fn long() -> Tape {
    let text = format!("%\n{}N002 M30\n", LINE.repeat(10_000));
    Tape::new(&text, &formats()[0])
}

#[test]
fn an_edit_in_the_middle_of_ten_thousand_blocks_reads_three_at_most() {
    let middle = 2 + 5_000 * LINE.len();
    // A digit, a word, a line end, a line, the joint of two lines, one character of a line end.
    for (from, to, insert) in [
        (middle + 12, middle + 13, "7"),
        (middle + 9, middle + 9, "G02 "),
        (middle + 9, middle + 9, "\n"),
        (middle, middle, LINE),
        (middle - 1, middle, ""),
        (middle - 1, middle, "\r\n"),
        (middle - 1, middle - 1, "*"),
        (middle + 5, middle + 5, "(A COMMENT)"),
    ] {
        let mut tape = long();
        tape.edit(from..to, insert);
        let (read, executed) = tape.last_work();
        assert!(read <= 3, "{insert:?}: {read}");
        // The path is absolute: it is as it was from the block behind the edit on, which the next mark shows.
        assert!(executed <= 1_000, "{insert:?}: {executed}");
    }
}

#[test]
fn closing_a_comment_gives_the_swallowed_blocks_back_unread() {
    let middle = 2 + 5_000 * LINE.len() + 5;
    let mut tape = long();
    let before = dump(&tape);
    tape.edit(middle..middle, "(");
    assert_eq!(tape.reading().blocks.len(), 5_001);
    tape.edit(middle + 1..middle + 1, "A");
    tape.edit(middle + 2..middle + 2, ")");
    assert_eq!(tape.reading().blocks.len(), 10_001);
    assert!(tape.last_work().0 <= 3, "{:?}", tape.last_work());
    tape.edit(middle..middle + 3, "");
    assert!(dump(&tape) == before);
}
