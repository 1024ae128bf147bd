//! Arcs: from what a block says to a centre and a sweep (4.2.2, figure 2).

use crate::format::{ArcCentre, Plane};
use crate::span::Arc;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Why an arc cannot be computed from its parameters.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ArcFault {
    /// Both parameters of the plane are zero.
    ZeroRadius,
    /// An arc of a control that stays within one quadrant crosses into another.
    LeavesQuadrant,
    /// The end is not on the circle: the radii at the ends, how the parameters were read, and the reading under which
    /// the end is on it.
    RadiusMismatch { start: f64, end: f64, tolerance: f64, read: ArcCentre, fits: Option<ArcCentre> },
    /// Angle and radius make another chord than the ends.
    ChordMismatch { chord: f64, ends: f64, tolerance: f64 },
    /// Angle and radius say of no arc.
    NotDetermined(Lack),
}

/// What an included angle and a radius lack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lack {
    /// I, the angle, is not given.
    Angle,
    /// J, the radius, is not given.
    Radius,
    /// The angle is not between zero and a full turn.
    AngleRange,
    /// The radius is negative.
    NegativeRadius,
    /// The arc ends where it starts: its centre may lie in any direction.
    Closed,
}

/// The largest difference between the radii at start and end that the rounding of the tape explains.
///
/// Start, end and centre may each be off by one least input increment in both axes: the worst case is 2√2 of them,
/// which is also what LinuxCNC reasons.
pub(crate) fn tolerance(increment: f64) -> f64 {
    2.0 * std::f64::consts::SQRT_2 * increment
}

/// What is known of an arc before its parameters are read. Points are first and second axis of the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ArcBlock {
    pub plane: Plane,
    pub start: [f64; 2],
    pub end: [f64; 2],
    pub clockwise: bool,
    /// Distance that the radii may differ by.
    pub tolerance: f64,
}

impl ArcBlock {
    /// The arc about a centre; a fault where the end is not on its circle.
    pub(crate) fn about(&self, centre: [f64; 2]) -> Result<Arc, ArcFault> {
        let from = [self.start[0] - centre[0], self.start[1] - centre[1]];
        let to = [self.end[0] - centre[0], self.end[1] - centre[1]];
        let (start, end) = (length(from), length(to));
        if start == 0.0 {
            return Err(ArcFault::ZeroRadius);
        }
        if (start - end).abs() > self.tolerance {
            let read = ArcCentre::Absolute;
            return Err(ArcFault::RadiusMismatch { start, end, tolerance: self.tolerance, read, fits: None });
        }
        let dot = from[0] * to[0] + from[1] * to[1];
        let cross = from[0] * to[1] - from[1] * to[0];
        let turn = libm::atan2(cross, dot);
        // End equal to start is a full circle; anything else within half a turn of atan2 is brought to the sense.
        let sweep = match (self.clockwise, self.start == self.end) {
            (true, true) => -TAU,
            (false, true) => TAU,
            (true, false) if turn >= 0.0 => turn - TAU,
            (false, false) if turn <= 0.0 => turn + TAU,
            _ => turn,
        };
        Ok(Arc {
            plane: self.plane,
            centre,
            start_radius: start,
            end_radius: end,
            start_angle: libm::atan2(from[1], from[0]),
            sweep,
        })
    }

    /// The arc of an included angle, in radians between 0 and 2π, and a positive radius. `angle_step` is the increment
    /// in which the tape says the angle.
    ///
    /// Ends, angle and radius say one thing too many: the chord 2R sin(a/2) must be the distance of the ends, but for
    /// the rounding of the tape, to which that of the angle adds R cos(a/2) for each radian. Within it the centre is
    /// put opposite the middle of the chord at the height R cos(a/2): neither a half turn nor a short arc makes that
    /// uncertain, as it would be by the chord and one of the two alone. It is negative for more than half a turn, which
    /// is the long way round.
    pub(crate) fn by_angle(&self, angle: f64, angle_step: f64, radius: f64) -> Result<Arc, ArcFault> {
        let along = [self.end[0] - self.start[0], self.end[1] - self.start[1]];
        let ends = length(along);
        let (sine, cosine) = libm::sincos(angle / 2.0);
        let chord = 2.0 * radius * sine;
        let tolerance = self.tolerance + radius * cosine.abs() * angle_step;
        if (chord - ends).abs() > tolerance {
            return Err(ArcFault::ChordMismatch { chord, ends, tolerance });
        }
        if ends == 0.0 {
            return Err(ArcFault::NotDetermined(Lack::Closed));
        }
        // The centre of a short counter-clockwise arc lies left of its chord.
        let height = radius * cosine * if self.clockwise { -1.0 } else { 1.0 } / ends;
        let middle = [(self.start[0] + self.end[0]) / 2.0, (self.start[1] + self.end[1]) / 2.0];
        self.about([middle[0] - along[1] * height, middle[1] + along[0] * height])
    }

    /// The arc stays within a quadrant about its centre, but for the rounding of the tape.
    pub(crate) fn is_in_quadrant(&self, arc: &Arc) -> bool {
        let from = [self.start[0] - arc.centre[0], self.start[1] - arc.centre[1]];
        let to = [self.end[0] - arc.centre[0], self.end[1] - arc.centre[1]];
        let slack = self.tolerance * arc.start_radius.max(arc.end_radius);
        // A quarter turn whose ends are rounded may come out a trace longer.
        arc.sweep.abs() <= FRAC_PI_2 + self.tolerance / arc.start_radius
            && (0..2).all(|axis| from[axis] * to[axis] >= -slack)
    }

    /// The arc through an intermediate point: `None` where the three points coincide or lie on a line.
    pub(crate) fn through(&self, middle: [f64; 2]) -> Option<Arc> {
        let a = [middle[0] - self.start[0], middle[1] - self.start[1]];
        let b = [self.end[0] - self.start[0], self.end[1] - self.start[1]];
        let cross = a[0] * b[1] - a[1] * b[0];
        let (aa, bb) = (a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1]);
        // The middle point's height over the chord is |cross| / |b|: below the rounding of the tape it is on the
        // chord, and the circle would be as good as arbitrary.
        if aa == 0.0 || bb == 0.0 || cross.abs() <= self.tolerance * bb.sqrt() {
            return None;
        }
        let offset = [(b[1] * aa - a[1] * bb) / (2.0 * cross), (a[0] * bb - b[0] * aa) / (2.0 * cross)];
        let centre = [self.start[0] + offset[0], self.start[1] + offset[1]];
        let from = [-offset[0], -offset[1]];
        let to = [self.end[0] - centre[0], self.end[1] - centre[1]];
        let turn = libm::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
        // The three points run counter-clockwise where the middle one lies right of the chord: cross > 0.
        let sweep = match cross > 0.0 {
            true if turn <= 0.0 => turn + TAU,
            false if turn >= 0.0 => turn - TAU,
            _ => turn,
        };
        Some(Arc {
            plane: self.plane,
            centre,
            start_radius: length(from),
            end_radius: length(to),
            start_angle: libm::atan2(from[1], from[0]),
            sweep,
        })
    }
}

impl Arc {
    /// The length along the arc, in the plane. With two radii, the mean one.
    pub(crate) fn length_in_plane(&self) -> f64 {
        (self.start_radius + self.end_radius) / 2.0 * self.sweep.abs()
    }
}

/// The length of a vector in a plane; see [`super::parabola::norm`].
pub(crate) fn length(vector: [f64; 2]) -> f64 {
    (vector[0] * vector[0] + vector[1] * vector[1]).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn block(start: [f64; 2], end: [f64; 2], clockwise: bool) -> ArcBlock {
        ArcBlock { plane: Plane::Xy, start, end, clockwise, tolerance: 1e-3 }
    }

    #[test]
    fn the_four_quarters_and_their_complements() {
        // By hand: unit circle about the origin from (1, 0).
        for (end, clockwise, sweep) in [
            ([0.0, 1.0], false, PI / 2.0),
            ([0.0, 1.0], true, -1.5 * PI),
            ([-1.0, 0.0], false, PI),
            ([-1.0, 0.0], true, -PI),
            ([0.0, -1.0], true, -PI / 2.0),
            ([1.0, 0.0], true, -2.0 * PI),
        ] {
            let arc = block([1.0, 0.0], end, clockwise).about([0.0, 0.0]).expect("on the circle");
            assert!((arc.sweep - sweep).abs() < 1e-15, "{end:?} {clockwise} {}", arc.sweep);
        }
    }

    #[test]
    fn a_three_point_arc_runs_through_its_middle_point() {
        // By hand: (0, 0), (1, 1), (2, 0) lie on the circle about (1, 0), clockwise.
        let arc = block([0.0, 0.0], [2.0, 0.0], true).through([1.0, 1.0]).expect("a circle");
        assert_eq!(arc.centre, [1.0, 0.0]);
        assert!((arc.sweep + PI).abs() < 1e-15);
        // The other way round the far side: (0, 0), (1, -1), (2, 0) is counter-clockwise.
        let arc = block([0.0, 0.0], [2.0, 0.0], true).through([1.0, -1.0]).expect("a circle");
        assert!((arc.sweep - PI).abs() < 1e-15);
        // Three quarters: (1, 0), (-1, 0), (0, -1) about the origin, counter-clockwise.
        let arc = block([1.0, 0.0], [0.0, -1.0], true).through([-1.0, 0.0]).expect("a circle");
        assert!((arc.sweep - 1.5 * PI).abs() < 1e-12);
    }

    #[test]
    fn an_arc_within_a_quadrant() {
        // By hand, unit circle: a quarter from an axis to the next; 60 degrees that cross the Y axis; half a turn.
        let (sine, cosine) = (0.5, 0.75_f64.sqrt());
        for (start, end, within) in
            [([1.0, 0.0], [0.0, 1.0], true), ([sine, cosine], [-sine, cosine], false), ([1.0, 0.0], [-1.0, 0.0], false)]
        {
            let block = block(start, end, false);
            let arc = block.about([0.0, 0.0]).expect("on the circle");
            assert_eq!(block.is_in_quadrant(&arc), within, "{start:?} {end:?}");
        }
    }

    #[test]
    fn points_on_a_line_or_together_make_no_circle() {
        assert_eq!(block([0.0, 0.0], [2.0, 2.0], true).through([1.0, 1.0]), None);
        assert_eq!(block([0.0, 0.0], [0.0, 0.0], true).through([1.0, 1.0]), None);
        assert_eq!(block([0.0, 0.0], [2.0, 0.0], true).through([0.0, 0.0]), None);
    }
}
