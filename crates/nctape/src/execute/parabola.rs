//! Parabolas: the quadratic curve by its tangent intersection point (4.2.3, figure 3).

/// A parabola P(t) = (1-t)² P0 + 2t(1-t) PT + t² P2: P0 start, PT tangent intersection point, P2 end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Parabola {
    pub start: [f64; 3],
    pub tangent: [f64; 3],
    pub end: [f64; 3],
}

impl Parabola {
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
        area <= tolerance * norm(chord)
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

    #[test]
    fn the_intermediate_point_is_half_way() {
        let parabola = Parabola::through([0.0, 0.0, 0.0], [5.0, 2.0, 0.0], [10.0, 0.0, 0.0]);
        assert_eq!(parabola.tangent, [5.0, 4.0, 0.0]);
    }
}
