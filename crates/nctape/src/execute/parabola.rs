//! Parabolas: the quadratic curve by its tangent intersection point (4.2.3, figure 3).

/// A parabola P(t) = (1-t)² P0 + 2t(1-t) PT + t² P2: P0 start, PT tangent intersection point, P2 end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Parabola {
    pub start: [f64; 3],
    pub tangent: [f64; 3],
    pub end: [f64; 3],
}

/// Why a parabola cannot be computed from its points or parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ParabolaFault {
    /// The intermediate point lies on the chord.
    Intermediate,
    /// The tangent intersection point lies on the chord.
    Tangent,
    /// A slope is not given: 0 for I, 1 for J.
    NoSlope(usize),
    /// The slopes are equal: the tangents do not meet.
    Parallel,
    /// A tangent runs through both ends.
    SlopeOfChord,
    /// The focus is the start or the end.
    FocusAtEnd,
    /// The focus lies between the ends on their line: two parabolas, mirror images of one another, are as good.
    FocusBetween,
    /// The focus lies on the line through the ends, and not between them.
    FocusOnLine,
}

impl Parabola {
    /// The parabola whose tangents at the ends have these slopes in a plane, second axis over first: their
    /// intersection is the tangent point, which must be further than a distance from the chord. Slopes say nothing of the third axis of the plane; it goes in proportion to
    /// the curve's parameter, as that of a helix to the angle, so that the span lies in one plane in space.
    pub(crate) fn by_slopes(
        start: [f64; 3],
        end: [f64; 3],
        [first, second, third]: [usize; 3],
        slopes: [f64; 2],
        tolerance: f64,
    ) -> Result<Parabola, ParabolaFault> {
        if slopes[0] == slopes[1] {
            return Err(ParabolaFault::Parallel);
        }
        let chord = subtract(end, start);
        let along = (chord[second] - slopes[1] * chord[first]) / (slopes[0] - slopes[1]);
        let mut tangent = [0.0; 3];
        tangent[first] = start[first] + along;
        tangent[second] = start[second] + slopes[0] * along;
        tangent[third] = (start[third] + end[third]) / 2.0;
        let curve = Parabola { start, tangent, end };
        // A tangent along the chord makes a straight line of what is seen in the plane, however the third axis moves.
        let seen = [start, tangent, end].map(|point| {
            let mut point = point;
            point[third] = 0.0;
            point
        });
        let [start, tangent, end] = seen;
        if (Parabola { start, tangent, end }).is_degenerate(tolerance) {
            return Err(ParabolaFault::SlopeOfChord);
        }
        Ok(curve)
    }

    /// The parabola about a focus, which must be further than a distance from the line through the ends.
    ///
    /// The directrix is as far from each end as the focus, so it touches the circles about the ends that run through
    /// the focus. These have two common tangents, and so there are two parabolas: from the focus, the arc of the one is
    /// seen under less than half a turn, that of the other under more. The first is taken, as an arc of a circle goes
    /// the short way: it is the flat one, and any longer arc can be divided into such.
    pub(crate) fn about(
        start: [f64; 3],
        focus: [f64; 3],
        end: [f64; 3],
        tolerance: f64,
    ) -> Result<Parabola, ParabolaFault> {
        let (from, to) = (subtract(focus, start), subtract(focus, end));
        let (r0, r2) = (norm(from), norm(to));
        if r0 <= tolerance || r2 <= tolerance {
            return Err(ParabolaFault::FocusAtEnd);
        }
        let chord = subtract(end, start);
        let reach = norm(chord);
        // Where start and end are one point, every directrix would do.
        if reach <= tolerance {
            return Err(ParabolaFault::FocusOnLine);
        }
        let along = chord.map(|component| component / reach);
        let x = dot(from, along);
        let square_to = |to: [f64; 3]| -> [f64; 3] {
            let x = dot(to, along);
            std::array::from_fn(|axis| to[axis] - x * along[axis])
        };
        // Twice: what is left the first time is small, and has not lost its part along the line in full.
        let beside = square_to(square_to(from));
        let y = norm(beside);
        if y <= tolerance {
            let between = x > 0.0 && x < reach;
            return Err(if between { ParabolaFault::FocusBetween } else { ParabolaFault::FocusOnLine });
        }
        let across = beside.map(|component| component / y);
        // The axis of the parabola, from directrix to focus: the ends are r0 and r2 away from the directrix. That with
        // the positive sine points to the side of the focus. Where the focus all but lies on the line through the ends,
        // a difference would lose every digit; so 1 - cos and 1 + cos are worked out from r² = x² + y² of both ends.
        let whole = r0 + r2 + reach;
        let less = 2.0 * plus(r0, x, y) / whole;
        let more = 2.0 * plus(r2, reach - x, y) / whole;
        let cosine = if less < more { 1.0 - less } else { more - 1.0 };
        let sine = (less * more).sqrt();
        let axis: [f64; 3] = std::array::from_fn(|i| cosine * along[i] + sine * across[i]);
        let side: [f64; 3] = std::array::from_fn(|i| sine * along[i] - cosine * across[i]);
        // In the coordinates u along the directrix and v along the axis from the vertex, v = u²/2p; the tangents at
        // u0 and u2 meet at u = (u0 + u2)/2, v = u0 u2/2p.
        // r0 + x cos + y sin, without a difference.
        let p = y * sine + if x < 0.0 { plus(r0, x, y) - x * less } else { plus(r0, -x, y) + x * more };
        let (u0, u2) = (y * cosine - x * sine, y * cosine - (x - reach) * sine);
        let (u, v) = ((u0 + u2) / 2.0, u0 * u2 / (2.0 * p) - p / 2.0);
        let tangent = std::array::from_fn(|i| focus[i] + side[i] * u + axis[i] * v);
        Ok(Parabola { start, tangent, end })
    }

    /// The parabola through an intermediate point whose tangent is parallel to the chord (figure 3: P1). That point
    /// is P(1/2), so PT = 2 P1 - (P0 + P2)/2.
    pub(crate) fn through(start: [f64; 3], middle: [f64; 3], end: [f64; 3]) -> Parabola {
        let tangent = std::array::from_fn(|axis| 2.0 * middle[axis] - (start[axis] + end[axis]) / 2.0);
        Parabola { start, tangent, end }
    }

    /// P(t).
    pub(crate) fn point(&self, t: f64) -> [f64; 3] {
        let s = 1.0 - t;
        std::array::from_fn(|i| s * s * self.start[i] + 2.0 * t * s * self.tangent[i] + t * t * self.end[i])
    }

    /// PT - P0: half the velocity at the start.
    pub(crate) fn a(&self) -> [f64; 3] {
        subtract(self.tangent, self.start)
    }

    /// P0 - 2 PT + P2: the direction of the parabola's axis.
    pub(crate) fn d(&self) -> [f64; 3] {
        std::array::from_fn(|axis| self.start[axis] - 2.0 * self.tangent[axis] + self.end[axis])
    }

    /// |A × D|: twice the area of the triangle P0 PT P2, from which all curvature follows.
    pub(crate) fn k(&self) -> f64 {
        norm(cross(self.a(), self.d()))
    }

    /// The tangent intersection point lies on the line through the ends, within a distance.
    pub(crate) fn is_degenerate(&self, tolerance: f64) -> bool {
        let chord = subtract(self.end, self.start);
        let area = norm(cross(self.a(), chord));
        area.is_nan() || area <= tolerance * norm(chord)
    }

    /// The point half way stands opposite a point of the chord that is more than a quarter of it off its middle.
    pub(crate) fn is_skewed(&self) -> bool {
        let chord = subtract(self.end, self.start);
        // The point half way less the middle of the chord is -D/4.
        dot(self.d(), chord).abs() > dot(chord, chord)
    }

    /// The length of the curve: the integral of |2(A + tD)| in closed form.
    pub(crate) fn length(&self) -> f64 {
        let (a, d) = (self.a(), self.d());
        let (speed, q) = (norm(a), norm(d));
        // Where the speed hardly changes its direction the closed form loses its digits by cancellation; there the
        // speed is all but linear in t, and five Gauss points are exact to the last bit.
        if q <= 1e-4 * speed {
            return gauss_length(a, d);
        }
        let t0 = -dot(a, d) / (q * q);
        let c = self.k() / q;
        let (v0, v1) = (-q * t0, q * (1.0 - t0));
        let antiderivative = |v: f64| {
            let root = libm::hypot(v, c);
            let logarithm = if c > 0.0 { c * c * libm::asinh(v / c) } else { 0.0 };
            v * root + logarithm
        };
        (antiderivative(v1) - antiderivative(v0)) / q
    }
}

/// r + x for r² = x² + y², of which r is positive: by y² where r and x all but cancel.
fn plus(r: f64, x: f64, y: f64) -> f64 {
    if x < 0.0 { y * y / (r - x) } else { r + x }
}

/// Gauss-Legendre, five points (Abramowitz and Stegun, table 25.4).
fn gauss_length(a: [f64; 3], d: [f64; 3]) -> f64 {
    const POINTS: [(f64, f64); 5] = [
        (0.0, 0.568_888_888_888_888_9),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
        (0.906_179_845_938_664, 0.236_926_885_056_189_08),
    ];
    let speed = |t: f64| 2.0 * norm(std::array::from_fn(|axis| a[axis] + t * d[axis]));
    POINTS.iter().map(|(x, weight)| weight * speed((x + 1.0) / 2.0)).sum::<f64>() / 2.0
}

pub(crate) fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The length of a vector. Coordinates are below 10^19, so that no square overflows and `hypot` has nothing to save;
/// the square root is exact to the last bit on every machine.
pub(crate) fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Simpson's rule over many panels: the truth for a smooth integrand, and no part of the code under test.
    fn simpson(parabola: &Parabola) -> f64 {
        let point = |t: f64| -> [f64; 3] {
            std::array::from_fn(|i| {
                let (p0, p1, p2) = (parabola.start[i], parabola.tangent[i], parabola.end[i]);
                2.0 * ((1.0 - t) * (p1 - p0) + t * (p2 - p1))
            })
        };
        let panels = 20_000;
        let speed = |index: usize| norm(point(index as f64 / panels as f64));
        let sum: f64 = (0..=panels)
            .map(|index| match index {
                0 => speed(index),
                _ if index == panels => speed(index),
                _ if index % 2 == 1 => 4.0 * speed(index),
                _ => 2.0 * speed(index),
            })
            .sum();
        sum / (3.0 * panels as f64)
    }

    #[test]
    fn length_equals_the_integral() {
        let cases = [
            ([0.0, 0.0, 0.0], [50.0, 1.0, 0.0], [0.0, 2.0, 0.0]),
            ([0.0, 0.0, 0.0], [5.0, 60.0, 7.0], [100.0, 0.0, -3.0]),
            // Nearly straight: the tangent point a hair off the middle of the chord.
            ([0.0, 0.0, 0.0], [50.0, 1e-4, 0.0], [100.0, 0.0, 0.0]),
            ([0.0, 0.0, 0.0], [50.0, 0.02, 0.0], [100.0, 0.0, 0.0]),
        ];
        for (start, tangent, end) in cases {
            let parabola = Parabola { start, tangent, end };
            let (length, truth) = (parabola.length(), simpson(&parabola));
            assert!((length - truth).abs() <= 1e-9 * truth, "{length} {truth}");
        }
    }

    #[test]
    fn skew_is_how_far_the_intermediate_point_is_from_the_middle() {
        // By hand: opposite 5, 7.4 and 7.6 of a chord of 10; the quarter is reached at 7.5.
        for (x, skewed) in [(5.0, false), (7.4, false), (7.6, true), (0.0, true)] {
            let parabola = Parabola::through([0.0, 0.0, 0.0], [x, 2.0, 0.0], [10.0, 0.0, 0.0]);
            assert_eq!(parabola.is_skewed(), skewed, "{x}");
        }
    }

    /// By hand, on y = x²/4, whose focus is (0, 1): from (-1, 0.25) to (2, 1) the tangents -x/2 - 0.25 and
    /// x - 1 meet in (0.5, -0.5).
    #[test]
    fn slopes_and_focus_give_the_tangent_point() {
        let (start, end) = ([-1.0, 0.25, 0.0], [2.0, 1.0, 0.0]);
        let slopes = Parabola::by_slopes(start, end, [0, 1, 2], [-0.5, 1.0], 1e-3).expect("slopes");
        assert_eq!(slopes.tangent, [0.5, -0.5, 0.0]);
        let focus = Parabola::about(start, [0.0, 1.0, 0.0], end, 1e-3).expect("a focus");
        let off = norm(subtract(focus.tangent, [0.5, -0.5, 0.0]));
        assert!(off < 1e-14, "{:?}", focus.tangent);
        let fault = |focus: [f64; 3]| Parabola::about(start, focus, end, 1e-3).expect_err("a fault");
        assert_eq!(fault(start), ParabolaFault::FocusAtEnd);
        assert_eq!(fault([0.0, 0.5, 0.0]), ParabolaFault::FocusBetween);
        assert_eq!(fault([6.0, 2.0, 0.0]), ParabolaFault::FocusOnLine);
        let parallel = Parabola::by_slopes(start, end, [0, 1, 2], [0.5, 0.5], 1e-3);
        assert_eq!(parallel, Err(ParabolaFault::Parallel));
        // A slope of the chord itself, however the third axis moves: in the plane it is a straight line.
        let along = Parabola::by_slopes([0.0; 3], [10.0, 0.0, 4.0], [0, 1, 2], [0.0, 1.0], 1e-3);
        assert_eq!(along, Err(ParabolaFault::SlopeOfChord));
    }

    /// The tangents at two points of a parabola meet as far from the focus as the mean proportional between the
    /// distances of the points, and are seen from there under equal angles.
    #[test]
    fn a_focus_close_to_the_line_through_the_ends_keeps_its_digits() {
        let focus = [0.0; 3];
        for (start, end) in [
            ([128.77, 0.000_002, 0.0], [129.77, 0.000_002, 0.0]),
            ([1465.8, 0.000_02, 0.0], [1475.8, 0.000_02, 0.0]),
            ([-131_510.0, 0.002, 0.0], [-131_610.0, 0.004, 0.0]),
            ([1e7, 0.001, 0.0], [2e7, 0.001, 0.0]),
            ([3.0, 4.0, 0.0], [-5.0, 12.0, 0.0]),
            ([-3.0, 0.5, 1.0], [5.0, 0.5, 2.0]),
        ] {
            let parabola = Parabola::about(start, focus, end, 1e-7).expect("a parabola");
            let tangent = parabola.tangent;
            let (r0, r2, way) = (norm(start), norm(end), norm(tangent));
            assert!((way * way - r0 * r2).abs() <= 1e-9 * r0 * r2, "{start:?} {end:?}: {tangent:?}");
            let cosines = [(start, r0), (end, r2)].map(|(point, r)| dot(point, tangent) / (r * way));
            assert!((cosines[0] - cosines[1]).abs() <= 1e-9, "{start:?} {end:?}: {tangent:?}");
        }
    }

    #[test]
    fn the_intermediate_point_is_half_way() {
        let parabola = Parabola::through([0.0, 0.0, 0.0], [5.0, 2.0, 0.0], [10.0, 0.0, 0.0]);
        assert_eq!(parabola.tangent, [5.0, 4.0, 0.0]);
    }
}
