//! Arcs: equal angles, as few as keep the tolerance.

use crate::span::Arc;

/// Chords of an arc of `sweep` radians whose radius is `radius`: the chord of an angle a is off the arc by
/// r (1 - cos(a/2)), so the fewest with their ends on the arc are s / (2 acos(1 - e/r)), rounded up.
pub(super) fn chords(radius: f64, sweep: f64, tolerance: f64, most: usize) -> usize {
    let sweep = sweep.abs();
    // A chord over half a turn or more would say nothing of the way round: two for more than half a turn, three for a
    // full circle, whose two would fall together.
    let turns = sweep / std::f64::consts::PI;
    let least = if turns > 1.5 {
        3.0
    } else if turns > 1.0 {
        2.0
    } else {
        1.0
    };
    let step = 2.0 * libm::acos((1.0 - tolerance / radius).max(-1.0));
    // A step of zero (a tolerance below the last digit of the radius) divides to infinity, which the limit catches.
    (sweep / step).ceil().max(least).min(most as f64) as usize
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
    let [first, second, third] = arc.plane.axes();
    let count = chords(arc.start_radius.max(arc.end_radius), arc.sweep, tolerance, most);
    for index in 1..count {
        let part = index as f64 / count as f64;
        let radius = arc.start_radius + (arc.end_radius - arc.start_radius) * part;
        let (sine, cosine) = libm::sincos(arc.start_angle + arc.sweep * part);
        let mut point = [0.0; 3];
        point[first] = arc.centre[0] + radius * cosine;
        point[second] = arc.centre[1] + radius * sine;
        point[third] = start[third] + (end[third] - start[third]) * part;
        give(point);
    }
}

#[cfg(test)]
mod tests {
    use super::chords;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

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
            assert_eq!(chords(radius, sweep, tolerance, usize::MAX), count, "r {radius} s {sweep} e {tolerance}");
        }
        assert_eq!(chords(1e12, TAU, 1e-12, 1000), 1000);
    }
}
