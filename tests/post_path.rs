//! Random CLDATA posted to random formats, and read back from the holes: the path is the same.

#[path = "support/numbers.rs"]
mod numbers;
#[path = "support/random_cldata.rs"]
mod random_cldata;

use nctape::cldata::{self, Cldata};
use nctape::code::{DecodeOptions, decode};
use nctape::post::{Arcs, postprocess_with};
use nctape::span::{Geometry, Span, SpanKind};
use nctape::{Severity, Tape};
use random_cldata::random_cldata;

/// How far a point is from the line through the ends of a span, or from its cylinder between its heights.
fn distance(span: &Span, at: [f64; 3]) -> f64 {
    let minus = |one: [f64; 3], two: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| one[axis] - two[axis]) };
    let dot = |one: [f64; 3], two: [f64; 3]| -> f64 { (0..3).map(|axis| one[axis] * two[axis]).sum() };
    match span.geometry {
        Geometry::Line => {
            let (way, off) = (minus(span.end, span.start), minus(at, span.start));
            let share = (dot(way, off) / dot(way, way)).clamp(0.0, 1.0);
            let off = minus(off, way.map(|part| part * share));
            dot(off, off).sqrt()
        }
        Geometry::Arc(arc) => {
            let [first, second, third] = arc.plane.axes();
            let radius = libm::hypot(at[first] - arc.centre[0], at[second] - arc.centre[1]);
            let (low, high) = (span.start[third].min(span.end[third]), span.start[third].max(span.end[third]));
            let beside = (low - at[third]).max(at[third] - high).max(0.0);
            libm::hypot(radius - arc.start_radius, beside)
        }
        _ => panic!("CLDATA has lines and arcs"),
    }
}

#[test]
fn the_path_of_the_tape_is_that_of_the_text() {
    let (mut arcs, mut lines, mut left) = (0, 0, 0);
    for number in 0..600 {
        let random = random_cldata(number);
        let old = Cldata::new(&random.source, &cldata::Options::default());
        assert_eq!(old.count(Severity::Error), 0, "{:?}", old.diagnostics());
        let posted = postprocess_with(&random.source, &random.format, &random.options);
        let told = format!("{number} {:?} {:?}\n{}\n{}", random.format, random.options, random.source, posted.text);
        let errors: Vec<&str> = posted
            .diagnostics
            .iter()
            .filter(|found| found.severity == Severity::Error)
            .map(|found| found.message.as_str())
            .collect();
        // A short piece of an arc has a reciprocal of time that F may have no digits for.
        if errors.iter().any(|message| message.contains("has no code in F")) {
            left += 1;
            continue;
        }
        assert!(errors.is_empty(), "{errors:?}\n{told}");
        // By way of the holes, in the code of the format.
        let punched = Tape::new(&posted.text, &random.format);
        let rows: Vec<u8> = punched.rows().bytes.clone();
        let code = punched.control().code;
        let listing = decode(&rows, DecodeOptions { code: Some(code), ..DecodeOptions::default() });
        let tape = Tape::new(&listing.text, &random.format);
        let faults: Vec<String> = tape
            .diagnostics()
            .iter()
            .filter(|found| found.severity == Severity::Error)
            .map(|found| format!("{} {}", found.id, found.message))
            .collect();
        assert!(faults.is_empty(), "{faults:?}\n{told}");
        let chorded = random.options.arcs != Some(Arcs::Circles);
        let tolerance = random.options.tolerance.unwrap_or(0.0);
        let half = random.increment / 2.0 + 1e-9;
        let mut others = tape.spans().list.iter();
        // The block that takes the tool to where the text begins.
        others.next();
        for span in &old.spans().list {
            // Ends are off by half an increment along each of three axes at most; of an arc ends and centre are, each
            // along two, and where the way is round to the far side the centre counts twice.
            let rounding = match span.geometry {
                Geometry::Line => 3.0_f64.sqrt() * half,
                _ => 3.0 * 2.0_f64.sqrt() * half,
            };
            let is_arc = span.geometry != Geometry::Line;
            let third = if let Geometry::Arc(arc) = span.geometry { arc.plane.axes()[2] } else { 2 };
            let is_helix = is_arc && span.start[third] != span.end[third];
            let loose = is_arc && (chorded || is_helix && !tape.control().helix);
            let within = rounding + if loose { tolerance } else { 0.0 };
            loop {
                let other = others.next().unwrap_or_else(|| panic!("{span:?} is lost\n{told}"));
                assert!(!other.substitute, "{other:?}\n{told}");
                assert_eq!(span.kind == SpanKind::Rapid, other.kind == SpanKind::Rapid, "{span:?} {other:?}\n{told}");
                let mut farthest = 0.0_f64;
                nctape::flatten::flatten_span(other, half, &mut |at| farthest = farthest.max(distance(span, at)));
                assert!(farthest <= within, "{farthest} > {within}: {other:?} for {span:?}\n{told}");
                if (0..3).all(|axis| (other.end[axis] - span.end[axis]).abs() <= half) {
                    break;
                }
            }
            // What is left of a circle behind a point that is as its end.
            if is_arc {
                while others.as_slice().first().is_some_and(|other| {
                    let ends = (0..3).all(|axis| (other.end[axis] - span.end[axis]).abs() <= half);
                    ends && other.length <= 4.0 * random.increment
                }) {
                    others.next();
                }
                arcs += 1;
            } else {
                lines += 1;
            }
        }
        assert_eq!(others.count(), 0, "{told}");
    }
    assert!(arcs > 3000 && lines > 3000 && left < 60, "{arcs} arcs, {lines} lines, {left} left out");
}
