//! Flattening and interpolation from the tape to the points. The truth is the implicit curve: the distance from the
//! centre for an arc, the quadratic relation of the two affine coordinates or the distances from focus and directrix for
//! a parabola, Newton's form of the polynomial through its points for a cubic.

// The truth is worked out with the standard library's functions, not with those that the core uses.
#![allow(clippy::disallowed_methods)]

use nctape::format::{ArcCentre, CurveKind, FeedCoding, Itemized, ParabolaParameters, SetPoint};
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

/// One block under a format with three decimal places on X, Y and Z, from a start in thousandths.
fn in_space(start: [i64; 3], blocks: &str, more: impl FnOnce(&mut Itemized)) -> Tape {
    let mut format = Format::new(Standard::Iso2539, "N3G2X+43Y+43Z+43I+43J+43K+43F4M2*").classified("CAM 333");
    format.itemized = Itemized {
        set_point: Some(SetPoint::InOrder(start.map(|increments| increments as f64 / 1000.0).to_vec())),
        arc_centre: Some(ArcCentre::FromStart),
        full_circle: Some(true),
        curves: Some([("G05".to_owned(), CurveKind::Cubic)].into()),
        ..Itemized::default()
    };
    more(&mut format.itemized);
    Tape::new(&format!("%\nN001F0300\n{blocks}N009M30\n"), &format)
}

fn xyz(tape: &Tape, tolerance: f64) -> Vec<[f64; 3]> {
    tape.points(tolerance).xyz.chunks(3).map(|point| [point[0], point[1], point[2]]).collect()
}

/// The distance of a point from a segment, in space.
fn off(point: [f64; 3], pair: &[[f64; 3]]) -> f64 {
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (along, from) = (minus(pair[1], pair[0]), minus(point, pair[0]));
    let square = dot(along, along);
    let part = if square > 0.0 { (dot(from, along) / square).clamp(0.0, 1.0) } else { 0.0 };
    let rest = minus(from, along.map(|component| part * component));
    dot(rest, rest).sqrt()
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    off(a, &[b, b])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, rng_seed: RngSeed::Fixed(4), ..ProptestConfig::default() })]

    /// A helix in each plane: the truth is the distance from its axis, and that the third axis goes with the angle.
    #[test]
    fn helices_keep_the_tolerance_in_space(
        plane in 0..3usize,
        centre in [-500_000i64..500_000, -500_000i64..500_000],
        // From a few increments, where the rounding of the ends is a part of the radius, to a large arc.
        radius in prop_oneof![4.0..40.0f64, 100.0..400_000.0f64],
        from in 0.0..std::f64::consts::TAU,
        turn in 0.5..6.0f64,
        rise in -300_000i64..300_000,
        clockwise: bool,
        tolerance in tolerance(),
    ) {
        let [first, second, third] = [[0, 1, 2], [2, 0, 1], [1, 2, 0]][plane];
        let way = if clockwise { -1.0 } else { 1.0 };
        let at = |angle: f64| {
            [centre[0] + (radius * angle.cos()).round() as i64, centre[1] + (radius * angle.sin()).round() as i64]
        };
        let (start, end) = (at(from), at(from + way * turn));
        prop_assume!(start != end && start != centre && end != centre);
        let in_order = |pair: [i64; 2], height: i64| {
            let mut point = [0; 3];
            (point[first], point[second], point[third]) = (pair[0], pair[1], height);
            point
        };
        let target = in_order(end, rise);
        let parameters = in_order([centre[0] - start[0], centre[1] - start[1]], 0);
        let words: String = [
            word('X', target[0]), word('Y', target[1]), word('Z', target[2]),
            ["I", "J", "K"].iter().enumerate().filter(|&(axis, _)| axis != third)
                .map(|(axis, letter)| word(letter.chars().next().unwrap_or(' '), parameters[axis])).collect(),
        ].concat();
        let block = format!("N002G{}\nN003G0{}{words}\n", 17 + plane, if clockwise { 2 } else { 3 });
        let tape = in_space(in_order(start, 0), &block, |_| {});
        prop_assert_eq!(tape.count(Severity::Error), 0, "{:?}", tape.diagnostics());
        let points = xyz(&tape, tolerance);
        let c = centre.map(|increments| increments as f64 / 1000.0);
        let polar = |p: [f64; 3]| {
            let (u, v) = (p[first] - c[0], p[second] - c[1]);
            ((u * u + v * v).sqrt(), v.atan2(u))
        };
        let ((r0, a0), (r1, a1)) = (polar(points[0]), polar(points[points.len() - 1]));
        let swept = way * (way * (a1 - a0)).rem_euclid(std::f64::consts::TAU);
        let height = rise as f64 / 1000.0;
        let truth = |part: f64| {
            let (r, a) = (r0 + (r1 - r0) * part, a0 + swept * part);
            let mut p = [0.0; 3];
            (p[first], p[second], p[third]) = (c[0] + r * a.cos(), c[1] + r * a.sin(), height * part);
            p
        };
        let chords = points.len() - 1;
        for (index, pair) in points.windows(2).enumerate() {
            // On the helix by its own angle, whatever drew it.
            let (r, a) = polar(pair[0]);
            let part = if index == 0 { 0.0 } else { way * (way * (a - a0)).rem_euclid(std::f64::consts::TAU) / swept };
            prop_assert!((part - index as f64 / chords as f64).abs() < 1e-9 && (r - (r0 + (r1 - r0) * part)).abs() < 1e-9);
            prop_assert!((pair[0][third] - height * part).abs() < 1e-6 * height.abs().max(1e-3));
            for step in 1..20 {
                let p = truth((index as f64 + f64::from(step) / 20.0) / chords as f64);
                prop_assert!(off(p, pair) <= tolerance * (1.0 + 1e-9) + 1e-9, "{} beyond {tolerance}", off(p, pair));
            }
        }
    }

    /// Any parabola by its focus: on it every point is as far from the focus as from the directrix, which is found
    /// here by trying directions.
    #[test]
    fn parabolas_by_their_focus_are_as_far_from_the_directrix(
        start in [-90_000i64..90_000, -90_000i64..90_000, -90_000i64..90_000],
        focus in [-90_000i64..90_000, -90_000i64..90_000, -90_000i64..90_000],
        end in [-90_000i64..90_000, -90_000i64..90_000, -90_000i64..90_000],
        tolerance in tolerance(),
    ) {
        let real = |point: [i64; 3]| point.map(|increments| increments as f64 / 1000.0);
        let (p0, f, p2) = (real(start), real(focus), real(end));
        prop_assume!(apart(p0, p2) > 1.0);
        let chord: Vec<f64> = (0..3).map(|axis| (p2[axis] - p0[axis]) / apart(p0, p2)).collect();
        let x: f64 = (0..3).map(|axis| (f[axis] - p0[axis]) * chord[axis]).sum();
        let beside: Vec<f64> = (0..3).map(|axis| f[axis] - p0[axis] - x * chord[axis]).collect();
        let y = beside.iter().map(|b| b * b).sum::<f64>().sqrt();
        prop_assume!(y > 1.0);
        let words = [word('X', end[0]), word('Y', end[1]), word('Z', end[2]),
            word('I', focus[0] - start[0]), word('J', focus[1] - start[1]), word('K', focus[2] - start[2])].concat();
        let tape = in_space(start, &format!("N002G06{words}\n"), |stated| {
            stated.parabola_parameters = Some(ParabolaParameters::Focus);
        });
        prop_assert_eq!(tape.count(Severity::Error), 0, "{:?}", tape.diagnostics());
        // In the plane of the three: along the chord and towards the focus. The directrix is normal to (cos a, sin a),
        // a from 0 to half a turn; the distances of the ends from it differ by as much as those from the focus.
        let (r0, r2, d) = (apart(p0, f), apart(p2, f), apart(p0, p2));
        let (mut low, mut high) = (0.0, std::f64::consts::PI);
        for _ in 0..100 {
            let middle: f64 = (low + high) / 2.0;
            if d * middle.cos() > r2 - r0 { low = middle } else { high = middle }
        }
        let (cosine, sine) = (low.cos(), low.sin());
        let points = xyz(&tape, tolerance);
        let mut turned = 0.0;
        let mut before: Option<[f64; 2]> = None;
        for &point in &points {
            let v: Vec<f64> = (0..3).map(|axis| point[axis] - p0[axis]).collect();
            let u: f64 = (0..3).map(|axis| v[axis] * chord[axis]).sum();
            let w: f64 = (0..3).map(|axis| v[axis] * beside[axis] / y).sum();
            let out = (v.iter().map(|v| v * v).sum::<f64>() - u * u - w * w).max(0.0).sqrt();
            let from_directrix = u * cosine + w * sine + r0;
            prop_assert!((apart(point, f) - from_directrix).abs() < 1e-6 && out < 1e-3, "{} {from_directrix}", apart(point, f));
            let here = [u - x, w - y];
            if let Some(b) = before {
                turned += (b[0] * here[1] - b[1] * here[0]).atan2(b[0] * here[0] + b[1] * here[1]);
            }
            before = Some(here);
        }
        // The focus sees it under less than half a turn; chords near a sharp turn may leap to its other side.
        let sharp = x * cosine + y * sine + r0 < 4.0 * tolerance;
        prop_assert!(sharp || turned.abs() < std::f64::consts::PI, "{turned}");
    }

    /// Flattening is within one chord of the least number, which is the integral of the curvature: here by the
    /// midpoint rule over many panels.
    #[test]
    fn parabolas_take_as_many_chords_as_the_integral_says(
        tangent in [-90_000i64..90_000, -90_000i64..90_000],
        end in [-90_000i64..90_000, -90_000i64..90_000],
        tolerance in prop::sample::select(vec![0.001, 0.01, 0.1]),
    ) {
        let [a, c] = [tangent, end].map(|point| point.map(|increments| increments as f64 / 1000.0));
        let d = [c[0] - 2.0 * a[0], c[1] - 2.0 * a[1]];
        let k = (a[0] * d[1] - a[1] * d[0]).abs();
        let speed = |t: f64| 2.0 * ((a[0] + t * d[0]).powi(2) + (a[1] + t * d[1]).powi(2)).sqrt();
        let panels = 4000;
        let speeds: Vec<f64> = (0..panels).map(|panel| speed((f64::from(panel) + 0.5) / f64::from(panels))).collect();
        let (slowest, fastest) = speeds.iter().fold((f64::MAX, 0.0_f64), |(low, high), &v| (low.min(v), high.max(v)));
        // No sharp turn, and no straight line.
        prop_assume!(slowest > fastest / 20.0 && k > 1.0);
        let integral = speeds.iter().map(|v| v.powf(-0.5)).sum::<f64>() / f64::from(panels);
        let fewest = ((k / (2.0 * tolerance)).sqrt() * integral).ceil();
        let block = ["G06".to_owned(), word('X', end[0]), word('Y', end[1]), word('I', tangent[0]), word('J', tangent[1])].concat();
        let tape = one_block([0, 0], &block);
        let chords = (tape.points(tolerance).span.len() - 1) as f64;
        prop_assert!((chords - fewest).abs() <= 1.0, "{chords} chords, {fewest} by the integral");
    }

    /// A cubic is the curve of third order through its four points; the truth is Newton's form of it.
    #[test]
    fn cubics_run_through_their_points_and_keep_the_tolerance(
        points in prop::array::uniform4([-90_000i64..90_000, -90_000i64..90_000, -90_000i64..90_000]),
        tolerance in tolerance(),
    ) {
        let blocks: String = (1..4).map(|index| {
            let [x, y, z] = points[index];
            let code = if index == 1 { "G05" } else { "" };
            format!("N00{}{code}{}{}{}\n", index + 1, word('X', x), word('Y', y), word('Z', z))
        }).collect();
        let tape = in_space(points[0], &blocks, |_| {});
        prop_assert_eq!(tape.count(Severity::Warning) + tape.count(Severity::Error), 0, "{:?}", tape.diagnostics());
        let p = points.map(|point| point.map(|increments| increments as f64 / 1000.0));
        // Differences: n runs from 0 to 3, and the first to third of them make P = p0 + n (d1 + (n-1)/2 (d2 + (n-2)/3 d3)).
        let differences = |axis: usize| {
            let [a, b, c, d] = [p[0][axis], p[1][axis], p[2][axis], p[3][axis]];
            [b - a, c - 2.0 * b + a, d - 3.0 * c + 3.0 * b - a]
        };
        let at = |n: f64| -> [f64; 3] {
            std::array::from_fn(|axis| {
                let [d1, d2, d3] = differences(axis);
                p[0][axis] + n * (d1 + (n - 1.0) / 2.0 * (d2 + (n - 2.0) / 3.0 * d3))
            })
        };
        let flat = xyz(&tape, tolerance);
        prop_assert_eq!((flat[0], flat[flat.len() - 1]), (p[0], p[3]));
        let samples = 6000;
        let curve: Vec<[f64; 3]> = (0..=samples).map(|i| at(3.0 * f64::from(i) / f64::from(samples))).collect();
        let fastest = curve.windows(2).map(|pair| apart(pair[0], pair[1])).fold(0.0, f64::max) * f64::from(samples) / 3.0;
        // Each vertex is on the curve, further on than the one before; each place of the curve between two of them is
        // within the tolerance of their chord. From a place that is so far off, the vertex cannot be nearer than that
        // at the greatest speed: so the first place that meets it is not leapt over.
        let mut place = 0.0_f64;
        let mut places = vec![0.0];
        for &vertex in &flat[1..flat.len() - 1] {
            while apart(at(place), vertex) > 1e-7 {
                place += apart(at(place), vertex) / (1.01 * fastest);
                prop_assert!(place < 3.0, "{vertex:?} is off the curve");
            }
            places.push(place);
        }
        places.push(3.0);
        for (pair, span) in flat.windows(2).zip(places.windows(2)) {
            for step in 1..20 {
                let n = span[0] + (span[1] - span[0]) * f64::from(step) / 20.0;
                prop_assert!(off(at(n), pair) <= tolerance + 1e-6, "{} beyond {tolerance}", off(at(n), pair));
            }
        }
        // Its count beside the least: the integral of √(curvature / 8e) over the length.
        let derivative = |n: f64| { let (a, b) = (at(n + 1e-4), at(n - 1e-4)); [0, 1, 2].map(|i| (a[i] - b[i]) / 2e-4) };
        let second = |n: f64| { let (a, m, b) = (at(n + 1e-2), at(n), at(n - 1e-2)); [0, 1, 2].map(|i| (a[i] - 2.0 * m[i] + b[i]) / 1e-4) };
        let norm = |v: [f64; 3]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        let mut integral = 0.0;
        let (mut slowest, mut fastest) = (f64::MAX, 0.0_f64);
        for panel in 0..2000 {
            let n = 3.0 * (f64::from(panel) + 0.5) / 2000.0;
            let (v, w) = (derivative(n), second(n));
            let cross = norm([v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]]);
            (slowest, fastest) = (slowest.min(norm(v)), fastest.max(norm(v)));
            integral += (cross / (norm(v) * 8.0 * tolerance)).sqrt() * 3.0 / 2000.0;
        }
        // Near a cusp the chords are longer than the integral says.
        if slowest > fastest / 10.0 && tolerance < 0.1 {
            let chords = (flat.len() - 1) as f64;
            prop_assert!(chords <= integral.ceil() * 1.02 + 2.0, "{chords} chords, {integral} by the integral");
        }
        // The length is that of the samples' polygon, which is short of it by its own chords.
        let polygon: f64 = curve.windows(2).map(|pair| apart(pair[0], pair[1])).sum();
        let length = tape.spans().list[0].length;
        prop_assert!(length >= polygon - 1e-9 * length && length <= polygon * (1.0 + 1e-5), "{length} {polygon}");
    }
}
