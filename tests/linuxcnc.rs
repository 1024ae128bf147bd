//! What LinuxCNC makes of a converted tape, beside the spans of the tape.
//!
//! `rs274` of Debian's `linuxcnc-uspace` runs a program by itself and prints its canonical motions, to four places. Where
//! it is installed it runs every preset, 500 random tapes and 100 that were posted from random CLDATA. Its output for twenty of them is recorded in
//! `tests/linuxcnc`, with the program that it was given, and compared everywhere. `RECORD=1 cargo test -p nctape --test
//! linuxcnc` has rs274 record it anew; nothing else writes those files.
//!
//! `NURBS_FEED`, which is what it prints of a quadratic spline, has no coordinates: the end of such a motion shows in the
//! motion behind it, and its control point is compared as it stands in the program.

#[path = "support/random_cldata.rs"]
#[allow(dead_code, reason = "the increment is of no use here")]
mod random_cldata;
#[path = "support/random_tape.rs"]
mod random_tape;

use nctape::convert::{Converted, Dialect, to_decimal};
use nctape::format::Unit;
use nctape::post::postprocess_with;
use nctape::span::{Arc, Geometry, Span, SpanKind};
use nctape::{Format, Severity, Tape, presets};
use random_cldata::random_cldata;
use random_tape::{numbers, random_tape};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

const RANDOM: u64 = 500;
const POSTED: u64 = 100;

/// Half of the last place that rs274 prints, and what writing and reading six more leaves.
const PRINTED: f64 = 0.000_050_1;

struct Case {
    name: String,
    format: Format,
    source: String,
}

fn cases(random: u64) -> Vec<Case> {
    let presets = presets::tapes().into_iter().map(|preset| Case {
        name: preset.id.to_owned(),
        format: preset.format,
        source: preset.source.to_owned(),
    });
    let random = (0..random).map(|number| {
        let tape = random_tape(number);
        Case { name: format!("random-{number:03}"), format: tape.format, source: tape.source }
    });
    presets.chain(random).collect()
}

/// Tapes that were posted from CLDATA; those are left out of which F cannot say the feed.
fn posted() -> impl Iterator<Item = Case> {
    (0..POSTED).filter_map(|number| {
        let random = random_cldata(number);
        let posted = postprocess_with(&random.source, &random.format, &random.options);
        (!posted.is_incomplete()).then(|| Case {
            name: format!("posted-{number:03}"),
            format: random.format,
            source: posted.text,
        })
    })
}

#[test]
fn recorded_motions_are_the_spans() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/linuxcnc");
    // All presets, and as many random tapes as make twenty.
    let cases = cases(20 - presets::tapes().len() as u64);
    assert_eq!(cases.len(), 20);
    let rs274 = std::env::var_os("RECORD").map(|_| rs274().expect("rs274 records"));
    let mut seen = Seen::default();
    for case in cases {
        let program = program(&case);
        let (ngc, canon) = (folder.join(format!("{}.ngc", case.name)), folder.join(format!("{}.canon", case.name)));
        if let Some(rs274) = &rs274 {
            std::fs::write(&ngc, &program).unwrap();
            std::fs::write(&canon, run(rs274, &ngc)).unwrap();
        }
        let given = std::fs::read_to_string(&ngc).unwrap_or_default();
        assert_eq!(program, given, "{}: another program than rs274 was given; record it anew", case.name);
        compare(&case, &program, &std::fs::read_to_string(&canon).unwrap(), &mut seen);
    }
    eprintln!("recorded: {seen:?}");
    assert!(seen.all_are_many(3), "{seen:?}");
}

#[test]
fn motions_of_rs274_are_the_spans() {
    let Some(rs274) = rs274() else {
        eprintln!("SKIPPED: rs274 of linuxcnc-uspace is not installed; its recorded motions are compared instead");
        return;
    };
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let mut seen = Seen::default();
    for case in cases(RANDOM).into_iter().chain(posted()) {
        let ngc = folder.join("tape.ngc");
        let program = program(&case);
        std::fs::write(&ngc, &program).unwrap();
        compare(&case, &program, &run(&rs274, &ngc), &mut seen);
    }
    eprintln!("rs274: {seen:?}");
    assert!(seen.all_are_many(200), "{seen:?}");
}

fn rs274() -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| folder.join("rs274")).find(|file| file.is_file())
}

/// What rs274 prints of a program. It keeps a file of parameters where it runs: one at a time.
fn run(rs274: &Path, ngc: &Path) -> String {
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock();
    let output = Command::new(rs274).arg("-g").arg(ngc).current_dir(env!("CARGO_TARGET_TMPDIR")).output().unwrap();
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}\n{}", std::fs::read_to_string(ngc).unwrap());
    printed
}

fn convert(case: &Case) -> Converted {
    let converted = to_decimal(&case.source, &case.format, Dialect::LinuxCnc);
    // Table positions of annex D, blocks of random tapes on which others rest, and G41, whose path is the cutter's: none
    // is a matter of the programmed path with the skip switch off.
    let expected = ["word-left-out", "skip-is-fixed", "function-left-out"];
    let weighs = |found: &&nctape::Diagnostic| found.severity > Severity::Info && !expected.contains(&found.rule.name);
    let faults: Vec<&str> = converted.diagnostics.iter().filter(weighs).map(|found| &*found.message).collect();
    assert!(faults.is_empty(), "{}: {faults:?}\n{}", case.name, case.source);
    converted
}

/// The converted tape, with the tool first brought to where the head says it stands.
fn program(case: &Case) -> String {
    let text = convert(case).text;
    let stands = "(Before the first block the tool stands at ";
    let at =
        text.lines().find_map(|line| line.strip_prefix(stands)).expect("where the tool stands").trim_end_matches(')');
    let modes = text.lines().find(|line| line.starts_with("G2")).expect("the modes");
    text.replacen(modes, &format!("{modes}\nG0 {at}"), 1)
}

/// How much was compared.
#[derive(Debug, Default)]
struct Seen {
    rapid: usize,
    line: usize,
    arc: usize,
    full: usize,
    helix: usize,
    splines: usize,
    chords: usize,
    feeds: usize,
}

impl Seen {
    fn all_are_many(&self, least: usize) -> bool {
        let Seen { rapid, line, arc, full, helix, splines, chords, feeds } = *self;
        [rapid, line, arc, full * 10, helix, splines, chords, feeds].iter().all(|&count| count >= least)
    }
}

/// A canonical motion.
#[derive(Clone, Debug)]
struct Motion {
    name: String,
    numbers: Vec<f64>,
    plane: String,
    /// Unit per minute.
    feed: f64,
}

fn motions(canon: &str) -> Vec<Motion> {
    let (mut plane, mut feed, mut per_revolution, mut speed) = ("XY".to_owned(), 0.0, false, 0.0);
    let mut lead = None;
    let mut motions = Vec::new();
    for line in canon.lines() {
        // The number of the line and the sequence number stand before the function.
        let Some((name, arguments)) = line.get(12..).and_then(|line| line.split_once('(')) else { continue };
        let name = name.trim();
        let arguments = arguments.trim_end_matches(')');
        let numbers: Vec<f64> = arguments.split(',').filter_map(|number| number.trim().parse().ok()).collect();
        match name {
            "SELECT_PLANE" => plane = arguments.trim_start_matches("CANON_PLANE_").to_owned(),
            "SET_FEED_MODE" => per_revolution = numbers[1] == 1.0,
            "SET_FEED_RATE" => feed = numbers[0],
            "SET_SPINDLE_SPEED" => speed = numbers[1],
            // A thread goes on by its lead with every revolution.
            "START_SPEED_FEED_SYNC" => lead = Some(numbers[0]),
            "STOP_SPEED_FEED_SYNCH" => lead = None,
            "STRAIGHT_TRAVERSE" | "STRAIGHT_FEED" | "ARC_FEED" | "NURBS_FEED" => {
                let feed = match lead {
                    Some(lead) => lead * speed,
                    None if per_revolution => feed * speed,
                    None => feed,
                };
                motions.push(Motion { name: name.to_owned(), numbers, plane: plane.clone(), feed });
            }
            _ => {}
        }
    }
    motions
}

/// Walks along the motions of LinuxCNC and the spans of the tape together.
fn compare(case: &Case, program: &str, canon: &str, seen: &mut Seen) {
    let tape = Tape::new(&case.source, &case.format);
    let mut splines = program.lines().filter(|line| line.contains("G5.1"));
    let context = || format!("{}\n{}\n{program}\n{canon}", case.name, case.source);
    let mut motions = motions(canon).into_iter();
    let stands = motions.next().expect("the motion to the set point");
    let mut at: Vec<f64> = stands.numbers;
    for (index, span) in tape.spans().list.iter().enumerate() {
        let close = |one: f64, other: f64| (one - other).abs() <= PRINTED;
        let end = degrees(&tape, tape.spans().end(index));
        let start = degrees(&tape, tape.spans().start(index));
        assert!((0..at.len()).all(|axis| close(at[axis], start[axis])), "start of {span:?}: {at:?}\n{}", context());
        let mut next = |name: &str, at: &[f64]| {
            // A motion over no distance is no span.
            let found = motions.by_ref().find(|motion| {
                !motion.name.starts_with("STRAIGHT") || motion.numbers.iter().zip(at).any(|(to, at)| to != at)
            });
            let found = found.unwrap_or_else(|| panic!("{name} for {span:?} is missing\n{}", context()));
            assert_eq!(found.name, name, "{span:?}: {found:?}\n{}", context());
            found
        };
        match span.geometry {
            Geometry::Line => {
                let rapid = span.kind == SpanKind::Rapid;
                let motion = next(if rapid { "STRAIGHT_TRAVERSE" } else { "STRAIGHT_FEED" }, &at);
                at = motion.numbers;
                if rapid {
                    seen.rapid += 1;
                } else {
                    seen.line += 1;
                    feed(span, motion.feed, seen, &context);
                }
            }
            Geometry::Arc(arc) if is_accepted(&tape, &arc) => {
                let motion = next("ARC_FEED", &at);
                let [first, second, third] = arc.plane.axes();
                let plane = ["XY", "XZ", "YZ"][[2, 1, 0].iter().position(|axis| *axis == third).unwrap()];
                assert_eq!(motion.plane, plane, "{span:?}\n{}", context());
                let [to_first, to_second, of_first, of_second, turns, to_third, a, b, c] = motion.numbers[..] else {
                    panic!("{motion:?}")
                };
                let centre = close(of_first, arc.centre[0]) && close(of_second, arc.centre[1]);
                assert!(centre, "{span:?}: {motion:?}\n{}", context());
                assert_eq!(turns, arc.sweep.signum(), "{span:?}: {motion:?}\n{}", context());
                at = vec![0.0, 0.0, 0.0, a, b, c];
                (at[first], at[second], at[third]) = (to_first, to_second, to_third);
                feed(span, motion.feed, seen, &context);
                seen.arc += 1;
                seen.full +=
                    usize::from(span.start[first] == span.end[first] && span.start[second] == span.end[second]);
                seen.helix += usize::from(span.start[third] != span.end[third]);
            }
            Geometry::Parabola { tangent } if span.start[2] == span.end[2] && tangent[2] == span.start[2] => {
                next("NURBS_FEED", &at);
                let line = splines.next().expect("a spline of the program");
                let word = |letter: char| -> f64 {
                    let word = line.split(' ').find_map(|word| word.strip_prefix(letter)).expect("its word");
                    word.parse().expect("a number")
                };
                let control = [span.start[0] + word('I'), span.start[1] + word('J')];
                assert!((0..2).all(|axis| (control[axis] - tangent[axis]).abs() < 1e-8), "{span:?}: {line}");
                at = end.clone();
                seen.splines += 1;
            }
            _ => {
                // Straight cuts up to the end of the span, each on the curve.
                let tolerance = if case.format.detail.contains("52") { 0.005 } else { 0.0005 };
                while (0..3).any(|axis| !close(at[axis], end[axis])) {
                    let motion = next("STRAIGHT_FEED", &at);
                    feed(span, motion.feed, seen, &context);
                    at = motion.numbers;
                    let off = distance(span, [at[0], at[1], at[2]]);
                    assert!(off <= tolerance + PRINTED, "{off} off {span:?}: {at:?}\n{}", context());
                    seen.chords += 1;
                }
            }
        }
        assert!((0..at.len()).all(|axis| close(at[axis], end[axis])), "end of {span:?}: {at:?}\n{}", context());
    }
    let rest = motions.find(|motion| motion.numbers != at);
    assert!(rest.is_none(), "{rest:?} is no span\n{}", context());
}

/// X, Y, Z, A, B and C of a position.
fn degrees(tape: &Tape, position: Vec<f64>) -> Vec<f64> {
    let letters = tape.control().axes.iter().map(|axis| axis.letter);
    let mut at = vec![0.0; 6];
    for (letter, value) in letters.zip(position) {
        if let Some(place) = "XYZABC".find(letter) {
            at[place] = value;
        }
    }
    at
}

/// The feed of a motion is that of the span, as far as four places say. LinuxCNC takes the length of an arc from its
/// radius at the start.
fn feed(span: &Span, feed: f64, seen: &mut Seen, context: &dyn Fn() -> String) {
    let known = span.feed.expect("a feed");
    let within = 0.1 + 1e-3 * known;
    assert!((feed - known).abs() <= within, "feed {feed}, not {known}: {span:?}\n{}", context());
    seen.feeds += 1;
}

/// LinuxCNC's manual: the radii at the ends may differ by 0,005 mm or 0,0005 inch, or by a thousandth.
fn is_accepted(tape: &Tape, arc: &Arc) -> bool {
    let least = if tape.control().unit == Unit::Inch { 0.0005 } else { 0.005 };
    (arc.start_radius - arc.end_radius).abs() <= f64::max(least, 0.001 * arc.start_radius.min(arc.end_radius))
}

/// How far a point is from an arc whose radius changes in proportion to its angle.
fn distance_of_arc(span: &Span, arc: &Arc, point: [f64; 3]) -> f64 {
    let [first, second, third] = arc.plane.axes();
    let from = [point[first] - arc.centre[0], point[second] - arc.centre[1]];
    let turned = (libm::atan2(from[1], from[0]) - arc.start_angle) * arc.sweep.signum();
    // The end may lie a trace before the start, and the start behind the end, of a turn.
    let share = (turned + 1e-9).rem_euclid(std::f64::consts::TAU) / arc.sweep.abs();
    let radius = arc.start_radius + share * (arc.end_radius - arc.start_radius);
    let height = span.start[third] + share * (span.end[third] - span.start[third]);
    libm::hypot(libm::hypot(from[0], from[1]) - radius, point[third] - height)
}

/// How far a point is from the curve of a span; from a parabola, the least distance to points that lie close on it.
fn distance(span: &Span, point: [f64; 3]) -> f64 {
    let tangent = match span.geometry {
        Geometry::Parabola { tangent } => tangent,
        Geometry::Arc(arc) => return distance_of_arc(span, &arc, point),
        _ => panic!("{span:?}"),
    };
    let at = |t: f64, axis: usize| {
        let s = 1.0 - t;
        s * s * span.start[axis] + 2.0 * s * t * tangent[axis] + t * t * span.end[axis]
    };
    let off = |t: f64| (0..3).map(|axis| at(t, axis) - point[axis]).fold(0.0, libm::hypot);
    let (mut best, mut step) = (0.0, 0.01);
    for t in (0..=100).map(|part| f64::from(part) / 100.0) {
        best = if off(t) < off(best) { t } else { best };
    }
    // The distance falls towards the nearest point from both sides there.
    for _ in 0..60 {
        step *= 0.7;
        best = [best - step, best, best + step]
            .into_iter()
            .min_by(|one, other| off(*one).total_cmp(&off(*other)))
            .unwrap();
    }
    off(best)
}
