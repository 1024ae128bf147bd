//! The tapes that are measured. Each is the same in every run; `tests/bench_tapes.rs` holds that they are what they
//! claim to be.

use nctape::format::value::Positive;
use nctape::{Format, Standard};
use std::fmt::Write;

/// The format of all of them: absolute dimensions with sign, in micrometres, room for millions of blocks, and a reader so
/// fast that no block waits for it.
pub fn format() -> Format {
    let mut format = Format::new(Standard::Iso2539, "N7.G2.X+33.Y+33.Z+33.I+33.J+33.F4.M2*").classified("CSM 333");
    format.itemized.reader_speed = Some(Positive(10_000.0));
    format
}

/// A contouring program of `blocks` straight cuts, each with N, G, X, Y, Z and F.
pub struct Contour {
    /// As tape.
    pub tape: String,
    /// The same program as the peers read it: with decimal signs, and with nothing but line ends between the blocks.
    pub decimal: String,
}

/// A [`Contour`].
pub fn contour(blocks: usize) -> Contour {
    let mut tape = String::from("%\n");
    let mut decimal = String::new();
    let mut path = Path::new();
    for number in 1..=blocks {
        let [x, y, z] = path.step();
        let feed = 100 + number % 900;
        let end = if number == blocks { " M30" } else { "" };
        let _ = writeln!(tape, "N{number:07} G01 X{x:+07} Y{y:+07} Z{z:+07} F{feed:04}{end}");
        let [x, y, z] = [x, y, z].map(decimal_sign);
        let _ = writeln!(decimal, "N{number:07} G01 X{x} Y{y} Z{z} F{feed}{end}");
    }
    Contour { tape, decimal }
}

/// Of each hundred blocks ten are arcs, ten parabolas, ten hold a comment and one is faulty; the others cut straight.
/// Faults of six kinds take turns.
pub fn mixed(blocks: usize) -> String {
    let mut tape = String::from("%\n");
    let mut path = Path::new();
    for number in 1..=blocks {
        let end = if number == blocks { " M30" } else { "" };
        let n = format!("N{number:07}");
        let _ = match number % 10 {
            3 => {
                // A quarter, counter-clockwise, back towards the origin.
                let ([x, y, z], [right, up]) = (path.at, path.inwards(500 + number as i64 % 1500));
                path.at = [x + right, y + up, z];
                let [i, j] = if right == up { [x, y + up] } else { [x + right, y] };
                writeln!(tape, "{n} G03 X{:+07} Y{:+07} I{i:+07} J{j:+07} F0200{end}", x + right, y + up)
            }
            6 => {
                // Tangents that meet above the middle of the chord.
                let ([x, y, _], [right, up]) = (path.at, path.inwards(500 + number as i64 % 1500));
                path.at[0] = x + 2 * right;
                let [i, j] = [x + right, y + up];
                writeln!(tape, "{n} G06 X{:+07} Y{y:+07} I{i:+07} J{j:+07} F0150{end}", x + 2 * right)
            }
            at => {
                let [x, y, z] = path.step();
                match (at, number % 100) {
                    (8, _) => writeln!(tape, "{n} G01 X{x:+07} Y{y:+07} (PASS {})  F0300{end}", number / 10),
                    (_, 50) => writeln!(tape, "{}", faulty(number, [x, y, z])),
                    _ => writeln!(tape, "{n} G01 X{x:+07} Y{y:+07} Z{z:+07} F0300{end}"),
                }
            }
        };
    }
    tape
}

/// A block with one fault, which is an error.
fn faulty(number: usize, [x, y, z]: [i64; 3]) -> String {
    let n = format!("N{number:07}");
    match number / 100 % 6 {
        0 => format!("{n} G01 X{:+06} Y{y:+07} Z{z:+07} F0300", x / 10),
        1 => format!("{n} G01 X{x:+07} Y{y:+07} Z{z:+07} F300"),
        2 => format!("{n} G01 X{x:+07} Y{y:+07} Z{z:+07} H01 F0300"),
        3 => format!("{n} G01 X{x:+07} Y{y:+07} Z{} F0300", decimal_sign(z)),
        4 => format!("{n} G01 Y{y:+07} X{x:+07} Z{z:+07} F0300"),
        _ => format!("G01 X{x:+07} Y{y:+07} Z{z:+07} F0300"),
    }
}

/// Tapes that are built to be slow to read.
pub struct Awkward {
    /// What it is made of.
    pub name: &'static str,
    /// Makes one with so many of them.
    pub make: fn(usize) -> String,
    /// How many in the largest.
    pub most: usize,
}

/// All of them.
pub const AWKWARD: &[Awkward] = &[
    Awkward { name: "blocks, an error in each", make: errors, most: 10_000 },
    Awkward { name: "words in one block", make: words, most: 5_000_000 / " X+012345".len() },
    Awkward { name: "digits in one word", make: digits, most: 5_000_000 },
    Awkward { name: "tabs in one block", make: tabs, most: 5_000_000 },
    Awkward { name: "characters that no code has", make: strangers, most: 100_000 },
    Awkward { name: "blocks, a comment in each", make: comments, most: 100_000 },
    Awkward { name: "comments in one block", make: comments_together, most: 100_000 },
    Awkward { name: "blocks behind an unclosed parenthesis", make: unclosed, most: 100_000 },
    Awkward { name: "parentheses, all of them opened", make: opened, most: 100_000 },
    Awkward { name: "parentheses, all of them closed", make: closed, most: 100_000 },
    Awkward { name: "words, a closed parenthesis behind each", make: closed_words, most: 100_000 },
    Awkward { name: "words, an O in each", make: letters, most: 100_000 },
    Awkward { name: "program starts without a block", make: empty_programs, most: 100_000 },
    Awkward { name: "program starts", make: program_starts, most: 100_000 },
    Awkward { name: "blocks of one number", make: one_number, most: 100_000 },
    Awkward { name: "blocks with optional block skip", make: skips, most: 100_000 },
    Awkward { name: "points of one arc", make: unfinished, most: 100_000 },
];

fn errors(count: usize) -> String {
    each_block(count, |number| format!("N{number:07} G01 X+01234 Y{:+07} Z+000000 F0300", number % 1000 + 1))
}

fn words(count: usize) -> String {
    format!("%\nN0000001 G01{} M30\n", " X+012345".repeat(count))
}

fn digits(count: usize) -> String {
    format!("%\nN0000001 G01 X+{} M30\n", "7".repeat(count))
}

fn tabs(count: usize) -> String {
    format!("%\nN0000001{} G01 X+012345 M30\n", "\t".repeat(count))
}

fn strangers(count: usize) -> String {
    format!("%\nN0000001 G01 X+012345 {} M30\n", "é".repeat(count))
}

fn comments(count: usize) -> String {
    each_block(count, |number| format!("N{number:07} G01 X{:+07} (ROUGH) F0300", number % 1000 + 1))
}

fn comments_together(count: usize) -> String {
    format!("%\nN0000001 G01 {}X+012345 M30\n", "(ROUGH)".repeat(count))
}

fn unclosed(count: usize) -> String {
    contour(count).tape.replacen("G01", "(G01", 1)
}

fn opened(count: usize) -> String {
    each_block(count, |number| format!("N{number:07} G01 (X{:+07} F0300", number % 1000 + 1))
}

fn closed(count: usize) -> String {
    format!("%\nN0000001 {}\n", ")".repeat(count))
}

fn closed_words(count: usize) -> String {
    format!("%\nN0000001 {}\n", "X+001000)".repeat(count))
}

fn letters(count: usize) -> String {
    format!("%\nN0000001 {}\n", "X0O".repeat(count))
}

fn empty_programs(count: usize) -> String {
    format!("{}%\nN0000001 H01 M30\n", "%AB\n".repeat(count))
}

fn program_starts(count: usize) -> String {
    "%\nN0000001 H01 M30\n".repeat(count)
}

fn one_number(count: usize) -> String {
    each_block(count, |number| format!("N0000001 G01 X{:+07} F0300", number % 1000 + 1))
}

fn skips(count: usize) -> String {
    each_block(count, |number| format!("/N{number:07} G01 X{:+07} F0300", number % 1000 + 1))
}

fn unfinished(count: usize) -> String {
    each_block(count, |number| format!("N{number:07} G02 X{0:+07} Y{0:+07} F0300", number % 1000 + 1))
}

fn each_block(count: usize, block: impl Fn(usize) -> String) -> String {
    let mut tape = String::from("%\n");
    for number in 1..=count {
        tape.push_str(&block(number));
        tape.push('\n');
    }
    tape
}

/// 12345 as 12.345.
fn decimal_sign(value: i64) -> String {
    let sign = if value < 0 { "-" } else { "" };
    let value = value.unsigned_abs();
    format!("{sign}{}.{:03}", value / 1000, value % 1000)
}

/// A path that wanders about and never stands still.
struct Path {
    at: [i64; 3],
    noise: u64,
}

impl Path {
    /// From here it turns back, long before the six digits are used up.
    const FAR: i64 = 900_000;

    fn new() -> Path {
        Path { at: [0; 3], noise: 1 }
    }

    fn step(&mut self) -> [i64; 3] {
        for axis in 0..3 {
            let way = self.random() % 2000 + 1;
            let outwards = if self.at[axis] < 0 { -way } else { way };
            let back = self.at[axis].abs() > Self::FAR || self.random() % 2 == 0;
            self.at[axis] += if back { -outwards } else { outwards };
        }
        self.at
    }

    /// A way in X and Y towards the origin.
    fn inwards(&self, far: i64) -> [i64; 2] {
        [self.at[0], self.at[1]].map(|at| if at > 0 { -far } else { far })
    }

    /// Knuth's linear congruential generator (MMIX); its upper bits are the better ones.
    fn random(&mut self) -> i64 {
        self.noise = self.noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.noise >> 33) as i64
    }
}
