//! The path of the cutter's centre: worked by hand, and by its distance from the programmed path.

#[path = "support/edits.rs"]
#[allow(dead_code)]
mod edits;

use edits::Numbers;
use nctape::format::value::Positive;
use nctape::offset::{FaultKind, OffsetPath};
use nctape::span::Geometry;
use nctape::{Format, Standard, Tape};

fn format(radius: f64) -> Format {
    let mut format =
        Format::new(Standard::Iso2539, "N3G2X+33Y+33Z+33P+13Q+13R+13I+33J+33K+33F4M2*").classified("CAM 333");
    format.itemized.cutter_radius = Some(Positive(radius));
    format.itemized.compensation = Some(true);
    format
}

fn tape(radius: f64, blocks: &[&str]) -> Tape {
    let numbered = blocks.iter().enumerate().map(|(index, block)| format!("N{:03}{block}\n", index + 1));
    Tape::new(&format!("%\n{}", numbered.collect::<String>()), &format(radius))
}

fn far(way: [f64; 2]) -> f64 {
    (way[0] * way[0] + way[1] * way[1]).sqrt()
}

fn points(path: &OffsetPath) -> Vec<[f64; 3]> {
    path.xyz.chunks(3).map(|point| [point[0], point[1], point[2]]).collect()
}

fn assert_points(path: &OffsetPath, expected: &[[f64; 2]]) {
    let found = points(path);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        let off = far([found[0] - expected[0], found[1] - expected[1]]);
        assert!(off < 1e-9, "{found:?} is not {expected:?}");
    }
}

/// Counter-clockwise round a square of 20 with a cutter of radius 2 on its left: every corner is an inside corner, and
/// the offset is a square of 16 whose ends lie at the first and the last normal.
#[test]
fn inside_corners_are_where_the_lines_meet() {
    let inside = tape(2.0, &["G41", "G01X+020000F0300", "Y+020000", "X+000000", "Y+000000", "M30"]);
    let path = inside.offset(0.01).expect("compensation is in force");
    assert_points(&path, &[[0., 2.], [18., 2.], [18., 2.], [18., 18.], [18., 18.], [2., 18.], [2., 18.], [2., 0.]]);
    assert_eq!((path.starts, path.faults), (vec![0], vec![]));
}

/// The same square on its right: three outside corners, each with a quarter circle about it. With a tolerance that
/// allows one chord for each quarter only the ends of the sides are left.
#[test]
fn outside_corners_are_gone_round() {
    let blocks = ["G42", "G01X+020000F0300", "Y+020000", "X+000000", "M30"];
    let path = tape(2.0, &blocks).offset(10.0).unwrap();
    assert_points(&path, &[[0., -2.], [20., -2.], [22., 0.], [22., 20.], [20., 22.], [0., 22.]]);
    let fine = tape(2.0, &blocks).offset(0.001).unwrap();
    let round = points(&fine).into_iter().filter(|point| point[0] > 20.0 && point[1] < 0.0).collect::<Vec<_>>();
    assert!(round.len() > 20);
    assert!(round.iter().all(|point| (far([point[0] - 20.0, point[1]]) - 2.0).abs() < 1e-9));
}

/// A line, then a quarter circle of radius 10 that bends away to the left: tangential, and 10 - 2 on the inside.
#[test]
fn arcs_keep_their_centre() {
    let arc = tape(2.0, &["G41", "G01X+020000F0300", "G03X+030000Y+010000I+020000J+010000", "M30"]);
    let path = arc.offset(10.0).unwrap();
    assert_points(&path, &[[0., 2.], [20., 2.], [20., 2.], [28., 10.]]);
    // A line that comes down on a clockwise arc about (0, 0): x = 4 + 1 and the circle of radius 10 + 1 meet at √96.
    let blocks = ["G00X+004000Y+020000", "G41", "G01Y+009165F0300", "G02X+000000Y-010000I+000000J+000000", "M30"];
    let corner = tape(1.0, &blocks);
    let path = corner.offset(0.01).unwrap();
    let last = path.span.last().copied().unwrap();
    let first_of_arc = path.span.iter().position(|span| *span == last).unwrap();
    let met = points(&path)[first_of_arc];
    let expected = [5.0, 96.0_f64.sqrt()];
    assert!((met[0] - expected[0]).abs() < 1e-3 && (met[1] - expected[1]).abs() < 1e-3, "{met:?} {expected:?}");
}

/// Clause 5: P, Q and R at the beginning of a span, turning with an arc.
#[test]
fn a_vector_turns_with_its_span() {
    let blocks = [
        "G01X+020000P+0000Q-1000F0300",
        "G03X+030000Y+010000I+020000J+010000",
        "G01Y+020000P+1000Q+0000",
        "G40X+000000",
        "M30",
    ];
    let path = tape(2.0, &blocks).offset(10.0).unwrap();
    assert_points(&path, &[[0., -2.], [20., -2.], [20., -2.], [32., 10.], [32., 10.], [32., 20.]]);
}

#[test]
fn what_does_not_fit_is_said_and_left_out() {
    let kinds = |radius, blocks: &[&str]| {
        let path = tape(radius, blocks).offset(0.1).unwrap();
        path.faults.iter().map(|fault| (fault.span, fault.kind)).collect::<Vec<_>>()
    };
    let arc = ["G41", "G01X+020000F0300", "G03X+023000Y+003000I+020000J+003000", "G01Y+020000", "M30"];
    assert_eq!(kinds(5.0, &arc), [(1, FaultKind::InsideArc { radius: Some(3.0) })]);
    assert_eq!(kinds(2.0, &arc), []);
    let corner = ["G41", "G01X+020000F0300", "Y+003000", "X+040000", "M30"];
    assert_eq!(kinds(5.0, &corner), [(1, FaultKind::InsideCorner)]);
    // Between two inside corners 3 apart a cutter of radius 2 has no room.
    let slot = ["G41", "G01X+020000F0300", "Y+003000", "X+000000", "M30"];
    assert_eq!(kinds(2.0, &slot), [(1, FaultKind::TooShort)]);
}

#[test]
fn without_compensation_or_a_cutter_there_is_none() {
    assert_eq!(tape(2.0, &["G01X+020000F0300", "M30"]).offset(0.1), None);
    let mut format = format(2.0);
    format.itemized.cutter_radius = None;
    let tape = Tape::new("%\nN001G41\nN002G01X+020000F0300\nN003M30\n", &format);
    assert_eq!(tape.offset(0.1), None);
    assert!(tape.spans().offsets().is_empty(), "nothing is kept that nothing asks for");
}

/// Whatever the path: every point of the offset of a line or an arc lies at the radius of the cutter from it.
#[test]
fn the_offset_keeps_its_distance() {
    let mut numbers = Numbers::new(7);
    let mut seen = 0;
    for _ in 0..300 {
        let radius = 0.5 + numbers.below(40) as f64 / 10.0;
        let mut blocks = vec![["G41", "G42"][numbers.below(2)].to_owned()];
        let (mut x, mut y) = (0_i64, 0_i64);
        for _ in 0..8 {
            let place = |numbers: &mut Numbers| numbers.below(80_000) as i64 - 40_000;
            if numbers.below(2) == 0 {
                (x, y) = (place(&mut numbers), place(&mut numbers));
                blocks.push(format!("G01X{x:+07}Y{y:+07}F0300"));
            } else {
                // A quarter circle about a centre beside the start: its end is exact.
                let (i, j) = (numbers.below(20_000) as i64 + 300, numbers.below(20_000) as i64 + 300);
                let (cx, cy) = (x + i, y + j);
                (x, y) = (cx + j, cy - i);
                blocks.push(format!("G03X{x:+07}Y{y:+07}I{cx:+07}J{cy:+07}F0300"));
            }
        }
        blocks.push("M30".to_owned());
        let blocks: Vec<&str> = blocks.iter().map(String::as_str).collect();
        let tape = tape(radius, &blocks);
        let path = tape.offset(0.01).expect("in force");
        assert!(path.xyz.iter().all(|number| number.is_finite()));
        let spans = &tape.spans().list;
        for (point, span) in points(&path).iter().zip(&path.span) {
            let span = &spans[*span as usize];
            let along = |from: [f64; 3], to: [f64; 3]| {
                let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
                let length = far([dx, dy]);
                ((point[0] - from[0]) * dy / length - (point[1] - from[1]) * dx / length).abs()
            };
            let distance = match span.geometry {
                Geometry::Line => along(span.start, span.end),
                Geometry::Arc(arc) => {
                    (far([point[0] - arc.centre[0], point[1] - arc.centre[1]]) - arc.start_radius).abs()
                }
                _ => unreachable!("lines and arcs"),
            };
            // A joint about the corner at the start belongs to the span behind it.
            let corner = far([point[0] - span.start[0], point[1] - span.start[1]]);
            let off = (distance - radius).abs().min((corner - radius).abs());
            assert!(off < 1e-8, "{point:?} is {off} off in {blocks:?}");
            seen += 1;
        }
    }
    assert!(seen > 10_000, "{seen}");
}
