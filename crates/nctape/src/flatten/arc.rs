//! Arcs: equal angles, as few as keep the tolerance, and points by turning a direction on.

use crate::format::Plane;
use crate::span::Arc;
use std::f64::consts::PI;

/// The fewest chords of equal angle that keep the tolerance, at most `most`.
///
/// The chord of an angle a is off a circle by r (1 - cos(a/2)), so the fewest with their ends on the arc are
/// s / (2 acos(1 - e/r)), rounded up; acos(1 - x) = 2 asin(√(x/2)) keeps its digits where e/r is small.
fn chords(arc: &Arc, tolerance: f64, most: usize) -> usize {
    let sweep = arc.sweep.abs();
    let radius = arc.start_radius.max(arc.end_radius);
    // A chord over half a turn or more would say nothing of the way round: two for more than half a turn, three for a
    // full circle, whose two would fall together.
    let turns = sweep / PI;
    let least = if turns > 1.5 {
        3.0
    } else if turns > 1.0 {
        2.0
    } else {
        1.0
    };
    let step = 4.0 * libm::asin((tolerance / (2.0 * radius)).min(1.0).sqrt());
    // A step of zero (a tolerance below the last digit of the radius) divides to infinity, which the limit catches.
    let mut count = (sweep / step).ceil().max(least).min(most as f64);
    let slope = (arc.end_radius - arc.start_radius).abs() / sweep;
    if slope > 0.0 {
        // One more, at times, for the rounding of the tape.
        while count < most as f64 && spiral_error(radius, slope, sweep / count) > tolerance {
            count += 1.0;
        }
    }
    count as usize
}

/// How far, at most, an arc whose radius changes by `slope` for each radian is from the chord of an angle h.
///
/// The chord at the same part of the angle is off by no more than h²/8 |P''|, with |P''| = √(r² + 4 slope²). Or, for a
/// change that is small, taken apart: r is a + slope θ from the middle of the chord on, of which a gives the circle's
/// a (1 - cos(h/2)) and the rest slope h²/8 √(4 + h²/4). Both hold; the smaller counts.
fn spiral_error(radius: f64, slope: f64, h: f64) -> f64 {
    let bend = h * h / 8.0;
    let whole = bend * (radius * radius + 4.0 * slope * slope).sqrt();
    let sine = libm::sin(h / 4.0);
    let apart = (radius - slope * h / 2.0) * 2.0 * sine * sine + bend * slope * (4.0 + h * h / 4.0).sqrt();
    whole.min(apart)
}

/// Gives the points between the ends. The radius, and the third axis, go in proportion to the angle.
pub(super) fn inner_points(
    arc: &Arc,
    start: [f64; 3],
    end: [f64; 3],
    tolerance: f64,
    most: usize,
    give: &mut impl FnMut([f64; 3]),
) {
    let count = chords(arc, tolerance, most);
    let [first, second, third] = arc.plane.axes();
    let turning = Turning {
        arc,
        count,
        from: [start[first] - arc.centre[0], start[second] - arc.centre[1]],
        third: [start[third], end[third]],
    };
    match arc.plane {
        Plane::Xy => turning.run(&mut |first, second, third| give([first, second, third])),
        Plane::Zx => turning.run(&mut |first, second, third| give([second, third, first])),
        Plane::Yz => turning.run(&mut |first, second, third| give([third, first, second])),
    }
}

/// Points that are worked out side by side, so that none waits for the one before it.
const LANES: usize = 4;

/// Points between two directions that are worked out from their angles.
///
/// Between them a direction is turned on by a complex product, which adds √5 u to its relative error, u = 2^-53 (Brent,
/// Percival and Zimmermann, 2007), beside the error of the turn itself: below 18 u for four steps, made of a sine and
/// cosine within an ulp by three products. That is 21 u for each of 16 turns, and 4·10^-14 of the radius in all.
const BETWEEN_ANCHORS: usize = 16 * LANES;

struct Turning<'a> {
    arc: &'a Arc,
    count: usize,
    /// Start less centre.
    from: [f64; 2],
    /// The third axis at start and end.
    third: [f64; 2],
}

impl Turning<'_> {
    #[inline(always)]
    fn run(&self, give: &mut impl FnMut(f64, f64, f64)) {
        let Turning { arc, count, from, third } = *self;
        if count < 2 {
            return;
        }
        let part = 1.0 / count as f64;
        let step = arc.sweep * part;
        let one = direction(step);
        let two = product(one, one);
        let turns = [one, two, product(two, one), product(two, two)];
        let four = turns[LANES - 1];
        let start = from.map(|component| component / arc.start_radius);
        let (more_radius, more_third) = (arc.end_radius - arc.start_radius, third[1] - third[0]);
        for anchor in (0..count - 1).step_by(BETWEEN_ANCHORS) {
            let here = if anchor == 0 { start } else { product(start, direction(step * anchor as f64)) };
            let (mut x, mut y) = ([0.0; LANES], [0.0; LANES]);
            for lane in 0..LANES {
                [x[lane], y[lane]] = product(here, turns[lane]);
            }
            let last = (anchor + BETWEEN_ANCHORS).min(count - 1);
            let mut index = anchor + 1;
            while index <= last {
                let (mut first, mut second, mut height) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
                for lane in 0..LANES {
                    let along = (index as f64 + lane as f64) * part;
                    let radius = arc.start_radius + more_radius * along;
                    first[lane] = arc.centre[0] + radius * x[lane];
                    second[lane] = arc.centre[1] + radius * y[lane];
                    height[lane] = third[0] + more_third * along;
                    [x[lane], y[lane]] = product([x[lane], y[lane]], four);
                }
                if index + LANES <= last + 1 {
                    for lane in 0..LANES {
                        give(first[lane], second[lane], height[lane]);
                    }
                } else {
                    for lane in 0..=last - index {
                        give(first[lane], second[lane], height[lane]);
                    }
                }
                index += LANES;
            }
        }
    }
}

/// Cosine and sine.
fn direction(angle: f64) -> [f64; 2] {
    let (sine, cosine) = libm::sincos(angle);
    [cosine, sine]
}

/// The product of two complex numbers: a direction, turned on by another.
#[inline(always)]
fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

    fn arc(start_radius: f64, end_radius: f64, sweep: f64) -> Arc {
        Arc { plane: Plane::Xy, centre: [0.0, 0.0], start_radius, end_radius, start_angle: 0.0, sweep }
    }

    /// Counts worked out apart from this crate: r, s, e and the fewest chords with their ends on the arc.
    #[test]
    fn counts_are_the_fewest() {
        for (radius, sweep, tolerance, count) in [
            (20.0, FRAC_PI_2, 0.01, 25),
            (20.0, FRAC_PI_4, 0.01, 13),
            (20.0, TAU, 0.01, 100),
            (100.0, TAU, 0.01, 223),
            (1.0, TAU, 0.01, 23),
            (1.0, TAU, 5.0, 3),
            (1.0, 0.1, 5.0, 1),
        ] {
            let found = chords(&arc(radius, radius, sweep), tolerance, usize::MAX);
            assert_eq!(found, count, "r {radius} s {sweep} e {tolerance}");
        }
        assert_eq!(chords(&arc(1e12, 1e12, TAU), 1e-12, 1000), 1000);
    }

    /// Every point of as long a run as there is, against the angle that it should have.
    #[test]
    fn turning_on_keeps_to_the_circle() {
        for (count, sweep) in
            [(super::super::MOST_CHORDS, TAU), (1000, -3.0), (64, 1.5), (65, 1.5), (66, 1.5), (3, -TAU)]
        {
            let arc = arc(1.0, 1.0, sweep);
            let turning = Turning { arc: &arc, count, from: [1.0, 0.0], third: [0.0, 0.0] };
            let mut index = 0;
            turning.run(&mut |x, y, _| {
                index += 1;
                let (sine, cosine) = libm::sincos(sweep * index as f64 / count as f64);
                let (off, radial) = ((x - cosine).abs().max((y - sine).abs()), (x * x + y * y).sqrt() - 1.0);
                assert!(off < 5e-14 && radial.abs() < 5e-14, "{index} of {count}: {off:e} {radial:e}");
            });
            assert_eq!(index, count - 1);
        }
    }

    /// Arcs of a few increments, whose radius changes by a good part of itself, against a hundred places of each chord.
    #[test]
    fn spirals_keep_the_tolerance() {
        for (from, to) in [(1.0, 1.1), (1.0, 2.0), (2.0, 0.5), (0.1, 3.0), (20.0, 20.003), (1.0, 1.0)] {
            for sweep in [0.3, FRAC_PI_2, 3.0, -4.0, TAU] {
                for tolerance in [1e-4, 1e-2, 0.3, 2.0] {
                    let arc = arc(from, to, sweep);
                    let mut points = vec![[from, 0.0]];
                    let end = [to * libm::cos(sweep), to * libm::sin(sweep)];
                    inner_points(&arc, [from, 0.0, 0.0], [end[0], end[1], 0.0], tolerance, usize::MAX, &mut |p| {
                        points.push([p[0], p[1]]);
                    });
                    points.push(end);
                    let count = points.len() - 1;
                    for (index, pair) in points.windows(2).enumerate() {
                        for part in 1..100 {
                            let along = (index as f64 + f64::from(part) / 100.0) / count as f64;
                            let (radius, angle) = (from + (to - from) * along, sweep * along);
                            let place = [radius * libm::cos(angle), radius * libm::sin(angle)];
                            let off = to_segment(place, pair[0], pair[1]);
                            assert!(off <= tolerance * (1.0 + 1e-9), "{from} {to} {sweep} {tolerance}: {off}");
                        }
                    }
                }
            }
        }
    }

    fn to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
        let (v, w) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        let square = v[0] * v[0] + v[1] * v[1];
        let part = if square > 0.0 { ((v[0] * w[0] + v[1] * w[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
        libm::hypot(w[0] - part * v[0], w[1] - part * v[1])
    }
}
