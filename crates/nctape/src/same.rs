//! Whether two tapes cut the same path.
//!
//! Two paths are the same within a tolerance where one can go along each of them, from start to end and never back, and
//! be no further from one another than the tolerance at any time: their Fréchet distance is at most that. So order and
//! direction count, and how a path is divided into blocks does not; an arc is the same as the chords that keep to it.
//! A stretch of rapid traverse is the same as no stretch at feed. Only X, Y and Z are looked at: neither feed, nor
//! functions, nor other axes, nor dwells.
//!
//! Decided over the free space of the two chords by chords (Alt and Godau, *Computing the Fréchet distance between two
//! polygonal curves*, 1995).

use crate::Tape;
use crate::flatten::flatten;
use crate::format::Unit;
use crate::span::{Span, SpanKind};

/// Curves are taken as chords that keep a sixteenth of the tolerance: of two paths whose distance is not within an
/// eighth of the tolerance beside it, the answer is the one for the curves themselves.
const CHORD: f64 = 1.0 / 16.0;

/// Pairs of chords that are looked at. Paths that are the same need about as many as they have chords together; where
/// more than this are wanted, as for two long scribbles within one tolerance, the answer is no.
const MOST_PAIRS: usize = 1 << 26;

type Point = [f64; 3];

/// A stretch of path, either all rapid or all at feed, without points that repeat.
struct Stretch {
    rapid: bool,
    points: Vec<Point>,
}

/// Whether the path of a tape is that of another within a tolerance above zero, in the unit of the first one's format.
///
/// A path with a stand-in for what could not be computed is the same as no other.
pub fn same_path(tape: &Tape, other: &Tape, tolerance: f64) -> bool {
    if tolerance.is_nan() || tolerance <= 0.0 {
        return false;
    }
    let unit = |tape: &Tape| if tape.control().unit == Unit::Inch { 25.4 } else { 1.0 };
    let scale = unit(other) / unit(tape);
    let (Some(one), Some(two)) = (stretches(tape, tolerance, 1.0), stretches(other, tolerance, scale)) else {
        return false;
    };
    let mut pairs = MOST_PAIRS;
    one.len() == two.len()
        && one.iter().zip(&two).all(|(a, b)| a.rapid == b.rapid && near(&a.points, &b.points, tolerance, &mut pairs))
}

/// The path in stretches, its lengths times `scale`; `None` where some of it is not known.
fn stretches(tape: &Tape, tolerance: f64, scale: f64) -> Option<Vec<Stretch>> {
    let spans: &[Span] = &tape.spans().list;
    if spans.iter().any(|span| span.substitute) {
        return None;
    }
    let points = flatten(spans, 0..spans.len(), tolerance * CHORD / scale);
    let mut found: Vec<Stretch> = Vec::new();
    for (place, &span) in points.xyz.chunks_exact(3).zip(&points.span) {
        let span = &spans[span as usize];
        if span.is_still() {
            continue;
        }
        let rapid = span.kind == SpanKind::Rapid;
        let point = [place[0] * scale, place[1] * scale, place[2] * scale];
        match found.last_mut() {
            Some(last) if last.rapid == rapid => {
                if last.points.last() != Some(&point) {
                    last.points.push(point);
                }
            }
            _ => found.push(Stretch { rapid, points: vec![point] }),
        }
    }
    Some(found)
}

/// Whether the Fréchet distance of two polylines is at most `far`.
///
/// Column i of the diagram is the chord from p[i]; of its left side we keep, for each chord of q that can be reached
/// there, from where to where along that chord.
fn near(p: &[Point], q: &[Point], far: f64, pairs: &mut usize) -> bool {
    let ends = |of: &[Point]| Some((*of.first()?, *of.last()?));
    let (Some((p_start, p_end)), Some((q_start, q_end))) = (ends(p), ends(q)) else {
        return p.is_empty() && q.is_empty();
    };
    if !within(p_start, q_start, far) || !within(p_end, q_end, far) {
        return false;
    }
    if p.len() == 1 || q.len() == 1 {
        // A point stands while the other goes: every corner of the other is near it, and so is what lies between.
        return p.iter().all(|&a| q.iter().all(|&b| within(a, b, far)));
    }
    let last = q.len() - 2;
    let mut left: Vec<(usize, Free)> = along(p[0], q, far);
    // The start of q stays near so far along p.
    let mut standing = true;
    for chord in p.windows(2) {
        let [from, to] = [chord[0], chord[1]];
        let mut right = Vec::new();
        let mut bottom = if standing { free(q[0], from, to, far) } else { None };
        standing = standing && within(to, q[0], far);
        let (mut j, mut next) = (0, 0);
        loop {
            if bottom.is_none() {
                match left.get(next) {
                    Some(&(reached, _)) => j = reached,
                    None => break,
                }
            }
            let side = left.get(next).filter(|(reached, _)| *reached == j).map(|&(_, free)| free);
            next += usize::from(side.is_some());
            if *pairs == 0 {
                return false;
            }
            *pairs -= 1;
            if let Some(reached) = onward(free(to, q[j], q[j + 1], far), bottom, side) {
                right.push((j, reached));
            }
            bottom = onward(free(q[j + 1], from, to, far), side, bottom);
            if j == last {
                break;
            }
            j += 1;
        }
        left = right;
        if left.is_empty() && !standing {
            // The last column may be left by its top alone, at the corner, which is of its right side too.
            return false;
        }
    }
    // The far corner is near, so a reached stretch of the last chord that goes to its end holds it.
    left.last().is_some_and(|(j, reached)| *j == last && reached.1 >= 1.0)
}

/// A stretch of a chord, in parts of it.
type Free = (f64, f64);

/// What of a far side is reached: all that is free, where the side next to it was reached; else what does not go back
/// behind where the opposite one was.
fn onward(free: Option<Free>, beside: Option<Free>, opposite: Option<Free>) -> Option<Free> {
    let (low, high) = free?;
    if beside.is_some() {
        return Some((low, high));
    }
    let from = opposite?.0.max(low);
    (from <= high).then_some((from, high))
}

/// The chords of q from its start on that lie near a point without a break.
fn along(point: Point, q: &[Point], far: f64) -> Vec<(usize, Free)> {
    let mut found = Vec::new();
    for (j, chord) in q.windows(2).enumerate() {
        let Some(reached) = free(point, chord[0], chord[1], far) else { break };
        found.push((j, reached));
        if reached.1 < 1.0 {
            break;
        }
    }
    found
}

/// Where the chord from a to b is no further than `far` from a point: a stretch of it, for a ball is convex.
fn free(point: Point, a: Point, b: Point, far: f64) -> Option<Free> {
    let (way, off) = (less(b, a), less(a, point));
    let (starts, ends) = (within(a, point, far), within(b, point, far));
    if starts && ends {
        return Some((0.0, 1.0));
    }
    let (square, half) = (dot(way, way), dot(off, way));
    let root = half * half - square * (dot(off, off) - far * far);
    if square <= 0.0 || root.is_nan() || root < 0.0 {
        return match (starts, ends) {
            (true, _) => Some((0.0, 0.0)),
            (_, true) => Some((1.0, 1.0)),
            _ => None,
        };
    }
    let low = if starts { 0.0 } else { (-half - root.sqrt()) / square };
    let high = if ends { 1.0 } else { (-half + root.sqrt()) / square };
    let (low, high) = (low.max(0.0), high.min(1.0));
    (low <= high).then_some((low, high))
}

fn within(a: Point, b: Point, far: f64) -> bool {
    let way = less(a, b);
    dot(way, way) <= far * far
}

fn less(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Format, Standard};

    fn path(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().map(|&[x, y]| [x, y, 0.0]).collect()
    }

    fn is_near(p: &[[f64; 2]], q: &[[f64; 2]], far: f64) -> bool {
        let mut pairs = [MOST_PAIRS; 2];
        let found = near(&path(p), &path(q), far, &mut pairs[0]);
        assert_eq!(found, near(&path(q), &path(p), far, &mut pairs[1]), "the same the other way about");
        found
    }

    /// Distances that can be read off a drawing.
    #[test]
    fn finds_the_distance_of_small_drawings() {
        let straight = [[0.0, 0.0], [10.0, 0.0]];
        for (other, distance) in [
            (vec![[0.0, 1.0], [10.0, 1.0]], 1.0),
            (vec![[0.0, 0.0], [4.0, 0.0], [10.0, 0.0]], 1e-9),
            (vec![[0.0, 0.0], [5.0, 3.0], [10.0, 0.0]], 3.0),
            // To and fro by 4 along the line: the walker on it waits in the middle, 2 from either end.
            (vec![[0.0, 0.0], [7.0, 0.0], [3.0, 0.0], [10.0, 0.0]], 2.0),
            (vec![[10.0, 0.0], [0.0, 0.0]], 10.0),
        ] {
            assert!(is_near(&straight, &other, distance * 1.000_001), "{other:?}");
            assert!(distance < 1e-6 || !is_near(&straight, &other, distance * 0.999_999), "{other:?}");
        }
    }

    /// Every point of each lies on the other, and yet they are not the same.
    #[test]
    fn tells_the_way_round() {
        let round = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [0.0, 0.0]];
        let mut back = round;
        back.reverse();
        assert!(is_near(&round, &round, 1e-9));
        assert!(!is_near(&round, &back, 4.9));
    }

    /// Against a table of all pairs of points of both, close together: the discrete distance (Eiter and Mannila, 1994),
    /// which is above the true one by no more than a step.
    #[test]
    fn agrees_with_the_discrete_distance() {
        let mut state = 7u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 16) / 65_536.0
        };
        for _ in 0..200 {
            let p: Vec<[f64; 2]> = (0..5).map(|i| [f64::from(i) + random(), random()]).collect();
            let q: Vec<[f64; 2]> = (0..7).map(|i| [f64::from(i) * 0.7 + random(), random()]).collect();
            let distance = discrete(&fine(&p), &fine(&q));
            assert!(is_near(&p, &q, distance * (1.0 + 1e-9)), "{p:?} {q:?}");
            assert!(!is_near(&p, &q, distance - 0.05), "{p:?} {q:?}");
        }
    }

    /// Each chord in 64 steps, none longer than 2.3 / 64 = 0.036.
    fn fine(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut found = vec![points[0]];
        for pair in points.windows(2) {
            for step in 1..=64 {
                let t = f64::from(step) / 64.0;
                found.push([pair[0][0] + t * (pair[1][0] - pair[0][0]), pair[0][1] + t * (pair[1][1] - pair[0][1])]);
            }
        }
        found
    }

    fn discrete(p: &[[f64; 2]], q: &[[f64; 2]]) -> f64 {
        let mut row = vec![f64::INFINITY; q.len()];
        for (i, a) in p.iter().enumerate() {
            let mut corner = if i == 0 { 0.0 } else { f64::INFINITY };
            let mut before = f64::INFINITY;
            for (j, b) in q.iter().enumerate() {
                let way = libm::hypot(a[0] - b[0], a[1] - b[1]);
                let reach = row[j].min(corner).min(before);
                corner = row[j];
                before = reach.max(way);
                row[j] = before;
            }
        }
        row[q.len() - 1]
    }

    fn tape(source: &str) -> Tape {
        let format = Format::new(Standard::Iso2539, "N3.G2.XL33.YL33.F4.M2*").classified("CSM 333");
        Tape::new(source, &format)
    }

    const SQUARE: &str =
        "%\nN001 G90 G01 X+010000 Y+000000 F0300\nN002 X+010000 Y+010000\nN003 G00 X+000000 Y+000000 M30\n";

    #[test]
    fn blocks_and_dimensions_do_not_matter() {
        let halved =
            "%\nN001 G91 G01 X+005000 Y+000000 F0200\nN002 X+005000\nN003 Y+010000\nN004 G00 X-010000 Y-010000 M30\n";
        let (square, halved) = (tape(SQUARE), tape(halved));
        assert_eq!((square.spans().list.len(), halved.spans().list.len()), (3, 4));
        assert!(same_path(&square, &halved, 0.001));
        assert!(same_path(&halved, &square, 0.001));
    }

    #[test]
    fn a_wrong_digit_a_cut_for_a_rapid_and_a_missing_block_do() {
        let square = tape(SQUARE);
        for (good, bad) in [("Y+010000", "Y+010100"), ("G00", "G01"), ("N002 X+010000 Y+010000\n", "")] {
            let other = tape(&SQUARE.replacen(good, bad, 1));
            assert!(!same_path(&square, &other, 0.09), "{bad}");
        }
        assert!(same_path(&square, &tape(&SQUARE.replace("Y+010000", "Y+010100")), 0.11));
    }

    #[test]
    fn no_tolerance_and_no_path_are_no_panic() {
        let (square, none) = (tape(SQUARE), tape("%\n"));
        assert!(!same_path(&square, &square, 0.0) && !same_path(&square, &square, f64::NAN));
        assert!(!same_path(&square, &none, 1e9) && same_path(&none, &none, 1.0));
        assert!(same_path(&square, &square, f64::INFINITY));
    }
}
