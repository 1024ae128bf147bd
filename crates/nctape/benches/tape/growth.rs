//! What ten times the tape takes: ten times as long, whatever it is made of.

use crate::measure::{grouped, median, shown};
use crate::{ask, tapes};
use nctape::Tape;
use std::hint::black_box;
use std::time::Duration;

/// What would take longer is not run, but reckoned from the sizes below it.
const PATIENCE: Duration = Duration::from_secs(30);

/// Prints the table of ordinary tapes.
pub fn run() {
    println!("\nThe full check by blocks.\n");
    println!("| tape | blocks | median | a block | times the tenth |");
    println!("| --- | --: | --: | --: | --: |");
    let contour = |blocks| tapes::contour(blocks).tape;
    grow("contour", contour, &[1000, 10_000, 100_000, 1_000_000]);
    grow("mixed", tapes::mixed, &[1000, 10_000, 100_000, 1_000_000]);
}

/// Prints the table of awkward tapes.
pub fn run_awkward() {
    println!("\nThe full check of tapes that are built to be slow.\n");
    println!("| made of | so many | median | each | times the tenth |");
    println!("| --- | --: | --: | --: | --: |");
    for awkward in tapes::AWKWARD {
        grow(awkward.name, awkward.make, &[awkward.most / 100, awkward.most / 10, awkward.most]);
    }
}

/// A row for each size, each ten times the one before.
fn grow(name: &str, make: impl Fn(usize) -> String, sizes: &[usize]) {
    let format = tapes::format();
    let mut before: Option<Duration> = None;
    let mut factor = 10.0;
    for &size in sizes {
        let expected = before.map_or(Duration::ZERO, |before| before.mul_f64(factor));
        if expected > PATIENCE {
            println!("| {name} | {} | not run: about {} | | |", grouped(size), shown(expected));
            before = Some(expected);
            continue;
        }
        let text = make(size);
        let time = median(|| ask(&Tape::new(black_box(&text), &format)));
        let grown = before.map(|before| time.as_secs_f64() / before.as_secs_f64());
        let each = shown(time.div_f64(size as f64));
        let times = grown.map(|grown| format!("{grown:.1}")).unwrap_or_default();
        println!("| {name} | {} | {} | {each} | {times} |", grouped(size), shown(time));
        factor = grown.unwrap_or(factor).max(10.0);
        before = Some(time);
    }
}
