//! Flattening and interpolation from the tape to the points. The truth is the implicit curve: the distance from the
//! centre for an arc, the quadratic relation of the two affine coordinates for a parabola.

// The truth is worked out with the standard library's functions, not with those that the core uses.
#![allow(clippy::disallowed_methods)]

use nctape::format::{ArcCentre, FeedCoding, Itemized, SetPoint};
use nctape::{Format, Severity, Standard, Tape};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// One block under a format with three decimal places, from a start in thousandths.
fn one_block(start: [i64; 2], block: &str) -> Tape {
    let format = Format {
        standard: Standard::Iso2539,
        classification: Some("CAM 222".to_owned()),
        detail: "N3G2X+43Y+43I+43J+43F4M2*".to_owned(),
        itemized: Itemized {
            set_point: Some(SetPoint::InOrder(start.map(|increments| increments as f64 / 1000.0).to_vec())),
            arc_centre: Some(ArcCentre::FromStart),
            feed: Some(FeedCoding::Direct),
            full_circle: Some(true),
            ..Itemized::default()
        },
    };
    let tape = Tape::new(&format!("%\nN001{block}F0300M30\n"), &format);
    assert_eq!(tape.count(Severity::Error), 0, "{:?}", tape.diagnostics());
    tape
}

fn word(address: char, increments: i64) -> String {
    format!("{address}{}{:07}", if increments < 0 { '-' } else { '+' }, increments.abs())
}

fn points(tape: &Tape, tolerance: f64) -> Vec<[f64; 2]> {
    tape.points(tolerance).xyz.chunks(3).map(|point| [point[0], point[1]]).collect()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt()
}

fn tolerance() -> impl Strategy<Value = f64> {
    prop::sample::select(vec![0.001, 0.01, 0.1, 1.0])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, rng_seed: RngSeed::Fixed(2539), ..ProptestConfig::default() })]

    #[test]
    fn arcs_keep_the_tolerance_with_the_fewest_chords(
        centre in [-500_000i64..500_000, -500_000i64..500_000],
        radius in 100.0..400_000.0f64,
        from in 0.0..std::f64::consts::TAU,
        turn in 0.05..6.2f64,
        clockwise: bool,
        tolerance in tolerance(),
    ) {
        let on_circle = |angle: f64| {
            [centre[0] + (radius * angle.cos()).round() as i64, centre[1] + (radius * angle.sin()).round() as i64]
        };
        let (start, end) = (on_circle(from), on_circle(if clockwise { from - turn } else { from + turn }));
        prop_assume!(start != end);
        let block = [
            if clockwise { "G02".to_owned() } else { "G03".to_owned() },
            word('X', end[0]),
            word('Y', end[1]),
            word('I', centre[0] - start[0]),
            word('J', centre[1] - start[1]),
        ];
        let tape = one_block(start, &block.concat());
        let points = points(&tape, tolerance);
        let centre = centre.map(|increments| increments as f64 / 1000.0);
        let (first, last) = (distance(points[0], centre), distance(points[points.len() - 1], centre));
        // The ends are rounded to the tape's increments, so their radii differ by up to 2√2 of them: the radius in
        // between is between theirs.
        let (low, high) = (first.min(last) - 1e-9, first.max(last) + 1e-9);
        for &point in &points {
            let r = distance(point, centre);
            prop_assert!(low <= r && r <= high, "{r} is not within {low} and {high}");
        }
        let mut swept = 0.0;
        for pair in points.windows(2) {
            let middle = [(pair[0][0] + pair[1][0]) / 2.0, (pair[0][1] + pair[1][1]) / 2.0];
            // The chord of the smallest radius bulges inward from the smallest radius at most by the tolerance.
            prop_assert!(distance(middle, centre) >= low - tolerance, "the chord leaves the tolerance");
            let (a, b) = ([pair[0][0] - centre[0], pair[0][1] - centre[1]], [pair[1][0] - centre[0], pair[1][1] - centre[1]]);
            let step = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
            // However coarse the tolerance, no step reaches half a turn.
            prop_assert!((step < 0.0) == clockwise);
            swept += step;
        }
        let chords = points.len() - 1;
        let fewest = (swept.abs() / (2.0 * (1.0 - tolerance / first.max(last)).max(-1.0).acos())).ceil();
        let turns = swept.abs() / std::f64::consts::PI;
        let least = if turns > 1.5 { 3.0 } else if turns > 1.0 { 2.0 } else { 1.0 };
        // A sweep that is a whole number of steps to the last bit may be counted either way.
        prop_assert!((chords as f64 - fewest.max(least)).abs() <= 1.0 && chords as f64 <= fewest.max(least) + 1.0);
    }

    #[test]
    fn parabolas_lie_on_the_curve_and_keep_the_tolerance(
        start in [-90_000i64..90_000, -90_000i64..90_000],
        tangent in [-90_000i64..90_000, -90_000i64..90_000],
        end in [-90_000i64..90_000, -90_000i64..90_000],
        tolerance in tolerance(),
    ) {
        let a = [tangent[0] - start[0], tangent[1] - start[1]];
        let chord = [end[0] - start[0], end[1] - start[1]];
        // The tangent point at least a tenth of a millimetre off the chord: a parabola by any measure.
        let height = (a[0] * chord[1] - a[1] * chord[0]).abs() as f64 / ((chord[0].pow(2) + chord[1].pow(2)) as f64).sqrt();
        prop_assume!(height > 100.0);
        let block = ["G06".to_owned(), word('X', end[0]), word('Y', end[1]), word('I', a[0]), word('J', a[1])].concat();
        let tape = one_block(start, &block);
        let points = points(&tape, tolerance);

        let (a, c) = (a.map(|v| v as f64 / 1000.0), chord.map(|v| v as f64 / 1000.0));
        let d = [c[0] - 2.0 * a[0], c[1] - 2.0 * a[1]];
        let p0 = start.map(|v| v as f64 / 1000.0);
        let determinant = a[0] * d[1] - a[1] * d[0];
        let mut parameters = Vec::new();
        for point in &points {
            // P - P0 = u A + v D with u = 2t and v = t²: on the curve u² = 4v.
            let q = [point[0] - p0[0], point[1] - p0[1]];
            let u = (q[0] * d[1] - q[1] * d[0]) / determinant;
            let v = (a[0] * q[1] - a[1] * q[0]) / determinant;
            prop_assert!((u * u - 4.0 * v).abs() < 1e-6, "u {u} v {v}");
            parameters.push(u / 2.0);
        }
        for (chord, span) in points.windows(2).zip(parameters.windows(2)) {
            prop_assert!(span[0] < span[1], "the points run forward");
            // The curve between the ends of each chord, against that chord itself.
            for step in 1..16 {
                let t = span[0] + (span[1] - span[0]) * f64::from(step) / 16.0;
                let at = [p0[0] + 2.0 * t * a[0] + t * t * d[0], p0[1] + 2.0 * t * a[1] + t * t * d[1]];
                let off = to_segment(at, chord[0], chord[1]);
                prop_assert!(off <= tolerance + 1e-9, "{off} is beyond {tolerance} at t {t}");
            }
        }
    }
}

/// The distance of a point from a segment.
fn to_segment(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let part = ((point[0] - from[0]) * along[0] + (point[1] - from[1]) * along[1]) / square;
    let part = if square > 0.0 { part.clamp(0.0, 1.0) } else { 0.0 };
    distance(point, [from[0] + part * along[0], from[1] + part * along[1]])
}
