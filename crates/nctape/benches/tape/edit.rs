//! An edit, and all that follows from it, beside a fresh check.

use crate::measure::{TIMES_HEAD, TIMES_RULE, Times, grouped, once};
use crate::{ask, tapes};
use nctape::Tape;
use std::hint::black_box;
use std::ops::Range;
use std::time::{Duration, Instant};

/// For each kind of edit at each size of tape.
const BUDGET: Duration = Duration::from_secs(2);

/// Prints the table.
pub fn run() {
    println!("\nAn edit of the contouring tape, and all that follows from it.\n");
    println!("| blocks | edit | {TIMES_HEAD} |");
    println!("| --: | --- | {TIMES_RULE} |");
    for blocks in [1000, 10_000, 100_000] {
        let text = tapes::contour(blocks).tape;
        for pair in pairs(&text) {
            let [there, back] = alternate(&text, &pair);
            println!("| {} | {} | {there} |", grouped(blocks), pair.there);
            if let Some(name) = pair.back {
                println!("| {} | {name} | {back} |", grouped(blocks));
            }
        }
        println!("| {} | none: a fresh check | {} |", grouped(blocks), fresh(&text));
    }
}

/// An edit and the one that takes it back.
struct Pair {
    there: &'static str,
    /// `None` where it is an edit of the same kind.
    back: Option<&'static str>,
    range: Range<usize>,
    insert: &'static str,
}

fn pairs(text: &str) -> [Pair; 5] {
    // The last digit of the X of the block at a place.
    let digit = |at: usize| text[at..].find('X').map_or(0, |x| at + x + "X+01234".len());
    let line = |at: usize| text[at..].find('\n').map_or(0, |end| at + end);
    let last = text.trim_end().rfind('\n').unwrap_or(0);
    let middle = text.len() / 2;
    let replace = |there, at: usize| Pair { there, back: None, range: at..at + 1, insert: "" };
    let add = |there, back, at, insert| Pair { there, back: Some(back), range: at..at, insert };
    [
        replace("a digit at the start", digit(0)),
        replace("a digit in the middle", digit(middle)),
        replace("a digit at the end", digit(last)),
        add("a new line in the middle", "taken out", line(middle), "\n"),
        add("a parenthesis opened in the middle", "taken out", line(middle), "("),
    ]
}

/// Makes the edit and takes it back, in turns.
fn alternate(text: &str, pair: &Pair) -> [Times; 2] {
    let mut tape = Tape::new(text, &tapes::format());
    let old = &text[pair.range.clone()];
    // Another digit of the same parity of length: the block stays what it was.
    let other = if old == "1" { "2" } else { "1" };
    let insert = if pair.back.is_none() { other } else { pair.insert };
    let inserted = pair.range.start..pair.range.start + insert.len();
    let mut times = [Vec::new(), Vec::new()];
    let start = Instant::now();
    while times[0].len() < 5 || (start.elapsed() < BUDGET && times[0].len() < 500) {
        times[0].push(once(|| edit(&mut tape, pair.range.clone(), insert)));
        times[1].push(once(|| edit(&mut tape, inserted.clone(), old)));
    }
    assert_eq!(tape.text(), text, "{} was not taken back", pair.there);
    let [mut there, back] = times;
    if pair.back.is_none() {
        there.extend(&back);
    }
    [there, back].map(Times::new)
}

fn edit(tape: &mut Tape, range: Range<usize>, insert: &str) {
    tape.edit(black_box(range), black_box(insert));
    ask(tape);
}

fn fresh(text: &str) -> Times {
    let mut times = Vec::new();
    let start = Instant::now();
    while times.len() < 5 || (start.elapsed() < BUDGET && times.len() < 500) {
        times.push(once(|| ask(&Tape::new(black_box(text), &tapes::format()))));
    }
    Times::new(times)
}
