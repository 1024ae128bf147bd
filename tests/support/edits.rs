//! Random edits of a tape where edits are awkward: inside CR LF, `*` with a line end, words, comments and surrogate
//! pairs; parentheses that open and close; whole stretches that go.

use nctape::format::value::Positive;
use nctape::format::{CompensationVector, CurveKind, Dimensions, Dwell, DwellUnit, FeedCoding};
use nctape::{Format, Standard, Tape};
use std::fmt::Write;

#[path = "numbers.rs"]
mod numbers;
pub use numbers::Numbers;

const PIECES: &[&str] = &[
    "\n",
    "\r\n",
    "\r",
    "*",
    "*\n",
    "*\r\n",
    "\n\n",
    "(",
    ")",
    "()",
    "(A)",
    "(\u{1F600})",
    "%",
    "%12",
    "/",
    "\t",
    " ",
    ":",
    "+",
    "-",
    ".",
    "O",
    "5",
    "00",
    "X",
    "N",
    "G02",
    "G03 X+010000 Y+005000 I+005000 J+000000",
    "N007 G01 X+001000 F0300\n",
    "N008 G02 X+020000 Y+010000\nN009 X+030000 Y+000000\n",
    "G91",
    "G41",
    "G42 X+002000",
    "G40",
    "P+0000 Q+1000",
    "P+0707",
    "P+0707 R-0707 F40",
    "R+000500",
    "G34 Z-001000 K+000100\n",
    "P+0000 Q+0000 R+0000",
    "B+090000",
    "G33 Z-002000 K+000150",
    "G90",
    "G06",
    "G05",
    "G05 X+001000\nX+002000 Y+001000\nX+003000\n",
    "M30",
    "M02\n",
    "M30\n%\n",
    "T05 M06",
    "F0",
    "\u{2212}",
    "\u{1F600}",
    "\u{0}",
    "x+000100",
    "/N010 X+001000\n",
    "(N011 G01\nN012 X+005000\n)",
    "1.5",
    "S0500",
    "G04 X+000150\n",
    "G33 X+001000 I+000200\n",
    "G95 F0002",
    "M03",
    "M05",
    "M41",
];

/// An edit of a text in UTF-16 code units: from, to, insert. It may fall between the halves of a surrogate pair.
pub fn edit(numbers: &mut Numbers, length: usize) -> (usize, usize, &'static str) {
    let from = numbers.below(length + 1);
    let removed = match numbers.below(12) {
        0..6 => 0,
        6..9 => 1,
        9 => 2,
        10 => numbers.below(30),
        _ => numbers.below(length / 4 + 2),
    };
    let insert = if removed > 0 && numbers.below(2) == 0 { "" } else { numbers.one_of(PIECES) };
    (from, (from + removed).min(length), insert)
}

/// A tape of blocks with a little of everything, long enough for an open comment to swallow many.
pub fn tape(blocks: usize) -> String {
    let mut text = String::from("(LEADER)\r\n%\n");
    for index in 1..blocks {
        let line = match index % 11 {
            0 => format!("N{index:03} G02 X+{index:06} Y+000000 I+000500 J+000000\r\n"),
            3 => format!("N{index:03} (PART {index}) G01 X+{:06} F0300*\n", index * 7),
            5 => format!("/N{index:03} Y+{:06}*", index * 3),
            7 => format!("N{index:03} G06 X+{index:06} Y+001000\nX+{:06} Y+000000\n", index + 900),
            8 => {
                format!("N{index:03} G05 X+{index:06} Y+001000\nX+{:06} Y+000000\nX+{:06}\n", index + 900, index + 1800)
            }
            9 => format!("N{index:03} X{index} (\u{1F600}\n)\n"),
            _ => format!("N{index:03} G01 X+{:06} Y-{index:06} F0200\n", index * 5),
        };
        text.push_str(&line);
    }
    text.push_str("N999 M30\n");
    text
}

/// Controls that read the same text in different ways.
pub fn formats() -> [Format; 7] {
    let mut incremental =
        Format::new(Standard::Iso2539, "N3.G2.XL42.YL42.ZL42.IL42.JL42.F4.T2.M2*").classified("CSM 332");
    incremental.itemized.dimensions = Some(Dimensions::Incremental);
    let mut absolute = Format::new(Standard::Iso2539, "N3G2X+42Y+42I+42J+42F4S4T2M2*").classified("CAM 222");
    absolute.itemized.dwell = Some(Dwell { address: 'X', unit: DwellUnit::Revolutions });
    absolute.itemized.curves = Some([("G05".to_owned(), CurveKind::Cubic)].into());
    let mut compensated =
        Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42P+13Q+13R+13I+42J+42B+33F4S3T3M2*").classified("CAMD 433");
    compensated.itemized.compensation = Some(true);
    compensated.itemized.cutter_radius = Some(Positive(2.5));
    compensated.itemized.compensation_digits = Some(1);
    let mut tangent = compensated.clone();
    tangent.detail = "N3G2XL42YL42ZL42PL13QL13RL13IL42JL42KL33B+33F2S2T3M2*".to_owned();
    tangent.itemized.compensation_vector = Some(CompensationVector::Tangent);
    tangent.itemized.maximum_feed = Some(Positive(200.0));
    (tangent.itemized.feed, tangent.itemized.decimal_shift) = (Some(FeedCoding::Geometric), Some(1));
    let mut rapid_z = Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42R+42I+42J+42F4S4T2M2*").classified("CAM 433");
    rapid_z.itemized.dwell = Some(Dwell { address: 'F', unit: DwellUnit::Seconds });
    [
        absolute,
        incremental,
        Format::new(Standard::Iso1058, "N3.G2.X+42.Y+42.F2.T2.M2*").classified("PTM 222"),
        Format::new(Standard::Rs274, "n3 g2 x+14 y+14 i+14 j+14 f21 m2*"),
        compensated,
        tangent,
        rapid_z,
    ]
}

/// All that can be asked of a tape.
pub fn dump(tape: &Tape) -> String {
    let mut out = String::new();
    let reading = tape.reading();
    for block in &reading.blocks {
        let words = reading.words(block);
        writeln!(out, "{:?} {} {} {:?} {words:?}", block.range, block.skip, block.program, tape.rows_of(block))
            .unwrap();
    }
    let rows = tape.rows();
    assert_eq!(rows.bytes.len(), reading.row_count());
    for program in reading.programs() {
        writeln!(out, "{program:?}").unwrap();
    }
    for found in tape.diagnostics() {
        let fixes: Vec<_> = found.fixes.iter().map(|fix| (&fix.title, &fix.edits)).collect();
        writeln!(out, "{} {:?} {} {} {:?} {fixes:?}", found.id, found.range, found.count, found.message, found.related)
            .unwrap();
    }
    for index in 0..tape.spans().list.len() {
        let (start, end) = (tape.spans().start(index), tape.spans().end(index));
        let offset = tape.spans().offsets().get(index);
        writeln!(out, "{:?} {start:?} {end:?} {offset:?}", tape.spans().list[index]).unwrap();
    }
    for registers in tape.registers_of(0..reading.blocks.len()) {
        writeln!(out, "{registers:?}").unwrap();
    }
    writeln!(out, "{:?} {:?} {rows:?}", tape.totals(), tape.bounds()).unwrap();
    out
}

/// The spans that are said to be kept are what they were, but for the numbers of their blocks.
fn assert_kept(before: &Tape, after: &Tape) {
    let kept = after.last_kept();
    let path = |tape: &Tape, spans: std::ops::Range<usize>| {
        let start = spans.start as u32;
        let points = tape.points_of(spans, 0.01);
        (points.xyz, points.span.iter().map(|span| span - start).collect::<Vec<_>>())
    };
    let (old, new) = (before.spans().list.len(), after.spans().list.len());
    assert_eq!(path(before, 0..kept.first), path(after, 0..kept.first));
    assert_eq!(path(before, old - kept.last..old), path(after, new - kept.last..new));
}

/// The bytes of a stretch of UTF-16 code units; a half of a pair counts as the whole one.
fn bytes(text: &str, from: usize, to: usize) -> std::ops::Range<usize> {
    let units = text.chars().scan(0, |unit, c| Some(std::mem::replace(unit, *unit + c.len_utf16())));
    let places: Vec<(usize, usize)> = units.zip(text.char_indices().map(|(at, _)| at)).collect();
    let byte = |unit: usize| places.get(places.partition_point(|it| it.0 < unit)).map_or(text.len(), |it| it.1);
    byte(from)..byte(to).max(byte(from))
}

/// Edits a tape so many times, and holds it to a fresh one after each.
pub fn edited(seed: u64, count: usize, first: &str) {
    let mut numbers = Numbers::new(seed);
    let formats = formats();
    let (mut format, mut skip) = (&formats[seed as usize % 5], false);
    let mut tape = Tape::with_skip(first, format, skip);
    for turn in 0..count {
        let before = tape.clone();
        match numbers.below(40) {
            0 => {
                format = &formats[numbers.below(5)];
                tape.set_format(format);
            }
            1 => {
                skip = !skip;
                tape.set_skip(skip);
            }
            _ => {
                let length = tape.text().encode_utf16().count();
                let (from, to, insert) = edit(&mut numbers, length);
                let range = bytes(tape.text(), from, to);
                tape.edit(range, insert);
            }
        }
        let fresh = Tape::with_skip(tape.text(), format, skip);
        assert_kept(&before, &tape);
        let (edited, fresh) = (dump(&tape), dump(&fresh));
        // A dump is thousands of lines: the first that differs says what is wrong.
        for (edited, fresh) in edited.lines().zip(fresh.lines()) {
            assert_eq!(edited, fresh, "seed {seed}, turn {turn}");
        }
        assert_eq!(edited.len(), fresh.len(), "seed {seed}, turn {turn}");
    }
}
