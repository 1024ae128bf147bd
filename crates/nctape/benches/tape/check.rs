//! The full check beside parsers of today's G-code, which merely parse.

use crate::ask;
use crate::measure::{Contestant, TIMES_HEAD, TIMES_RULE, compete, grouped, shown};
use crate::{peers, tapes};
use nctape::Tape;
use std::hint::black_box;
use std::time::Duration;

const BLOCKS: usize = 100_000;

/// Prints the table.
pub fn run() {
    let format = tapes::format();
    let contour = tapes::contour(BLOCKS);
    let mixed = tapes::mixed(BLOCKS);
    let check = |text: &str| ask(&Tape::new(black_box(text), &format));
    let parse = |peer: fn(&str) -> (usize, usize)| {
        black_box(peer(black_box(&contour.decimal)));
    };
    let mut contestants: [Contestant<'_>; 5] = [
        ("nctape: the full check", Box::new(|| check(&contour.tape))),
        ("nom-gcode 0.1.1: parsing, line by line", Box::new(|| parse(peers::nom_gcode))),
        ("gcode 0.7.0: parsing into a tree", Box::new(|| parse(peers::gcode_tree))),
        ("gcode 0.7.0: parsing, nothing kept", Box::new(|| parse(peers::gcode_visited))),
        ("nctape: the full check of the mixed tape", Box::new(|| check(&mixed))),
    ];
    let times = compete(&mut contestants, Duration::from_secs(20));
    println!("\nThe same program of {} blocks; the mixed tape is another.\n", grouped(BLOCKS));
    println!("| what | {TIMES_HEAD} | a block | beside nom-gcode |");
    println!("| --- | {TIMES_RULE} | --: | --: |");
    let nom = times[1].median().as_secs_f64();
    for ((name, _), times) in contestants.iter().zip(&times) {
        let median = times.median();
        println!("| {name} | {times} | {} | {:.2} |", shown(median / BLOCKS as u32), median.as_secs_f64() / nom);
    }
}
