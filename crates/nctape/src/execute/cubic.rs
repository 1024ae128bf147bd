//! Cubics: the curve of third order through points in successive blocks (4.2.4).

use super::parabola::{dot, norm, subtract};

/// A cubic by its ends and its two control points (Bézier): 3 (C1 - P0) and 3 (P3 - C2) are its velocities there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cubic {
    pub start: [f64; 3],
    pub control: [[f64; 3]; 2],
    pub end: [f64; 3],
}

/// P0 + t (a + t (b + t c)), from which values and derivatives follow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coefficients {
    pub a: [f64; 3],
    pub b: [f64; 3],
    pub c: [f64; 3],
}

impl Cubic {
    /// The cubic that runs through its start at t = 0 and through the other points at t = 1/3, 2/3 and 1.
    ///
    /// The standard leaves to the control how a higher curve goes through its points. Even steps of the parameter carry
    /// on what it has for the parabola, whose intermediate point is that of t = 1/2 (figure 3).
    pub(crate) fn through([p0, p1, p2, p3]: [[f64; 3]; 4]) -> Cubic {
        let weighted =
            |w: [f64; 4]| std::array::from_fn(|i| (w[0] * p0[i] + w[1] * p1[i] + w[2] * p2[i] + w[3] * p3[i]) / 6.0);
        let control = [weighted([-5.0, 18.0, -9.0, 2.0]), weighted([2.0, -9.0, 18.0, -5.0])];
        Cubic { start: p0, control, end: p3 }
    }

    pub(crate) fn coefficients(&self) -> Coefficients {
        let [c1, c2] = self.control;
        let (p0, p3) = (self.start, self.end);
        Coefficients {
            a: std::array::from_fn(|i| 3.0 * (c1[i] - p0[i])),
            b: std::array::from_fn(|i| 3.0 * (p0[i] - 2.0 * c1[i] + c2[i])),
            c: std::array::from_fn(|i| p3[i] - p0[i] + 3.0 * (c1[i] - c2[i])),
        }
    }

    /// P(t).
    pub(crate) fn point(&self, t: f64) -> [f64; 3] {
        let s = 1.0 - t;
        let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        let [c1, c2] = self.control;
        std::array::from_fn(|i| {
            weights[0] * self.start[i] + weights[1] * c1[i] + weights[2] * c2[i] + weights[3] * self.end[i]
        })
    }

    /// Where the coordinates of an axis turn back: the parameters strictly between the ends, at most two.
    pub(crate) fn turns(&self, axis: usize) -> impl Iterator<Item = f64> {
        let Coefficients { a, b, c } = self.coefficients();
        // a + 2bt + 3ct² = 0, by the form that loses no digits; what is not a number is not between the ends.
        let root = (b[axis] * b[axis] - 3.0 * a[axis] * c[axis]).sqrt();
        let q = -(b[axis] + root.copysign(b[axis]));
        [q / (3.0 * c[axis]), a[axis] / q].into_iter().filter(|t| *t > 0.0 && *t < 1.0)
    }

    /// The length of the curve, to a part in 10^12 at least.
    ///
    /// There is no closed form. On a piece whose velocity in the parameter -1 to 1 is v0 + v1 s + v2 s² with
    /// 4 |v1| + 16 |v2| ≤ 0.41 |v0|, the speed is analytic up to |s| = 4, because there |v·v - v0·v0| < |v0|². Eight
    /// Gauss points then are off by less than (64/15) M ρ^-14 / (1 - ρ^-2), ρ = 4 + √15, M ≤ 1.42 |v0| (Trefethen,
    /// Approximation Theory and Practice, theorem 19.3): a part in 10^12. Any other piece is halved, but those beside
    /// a cusp only until they are too short to count.
    pub(crate) fn length(&self) -> f64 {
        let Coefficients { a, b, c } = self.coefficients();
        let [c1, c2] = self.control;
        let polygon = norm(subtract(c1, self.start)) + norm(subtract(c2, c1)) + norm(subtract(self.end, c2));
        let mut length = 0.0;
        // Pieces from left to right: each is 2^-depth long, and `at` counts them in its own length.
        let (mut at, mut depth) = (0_u64, 0_u32);
        loop {
            let half = 0.5 / (1_u64 << depth) as f64;
            let middle = (2 * at + 1) as f64 * half;
            let v0: [f64; 3] = std::array::from_fn(|i| half * (a[i] + middle * (2.0 * b[i] + middle * 3.0 * c[i])));
            let v1: [f64; 3] = std::array::from_fn(|i| half * half * (2.0 * b[i] + 6.0 * middle * c[i]));
            let v2 = c.map(|c| half * half * half * 3.0 * c);
            let (n0, n1, n2) = (norm(v0), norm(v1), norm(v2));
            let smooth = 4.0 * n1 + 16.0 * n2 <= 0.41 * n0;
            if !smooth && depth < DEEPEST && n0 + n1 + n2 > NEGLIGIBLE * polygon {
                (at, depth) = (2 * at, depth + 1);
                continue;
            }
            length += gauss(v0, v1, v2);
            // On to the next piece, as long as the longest one that begins there.
            at += 1;
            while at % 2 == 0 && depth > 0 {
                (at, depth) = (at / 2, depth - 1);
            }
            if depth == 0 {
                return length;
            }
        }
    }
}

/// Pieces shorter than this part of the whole need not be smooth: there are a few dozen of them at most, at two cusps.
const NEGLIGIBLE: f64 = 1e-15;
/// No piece is shorter than 2^-52 of the parameter, in which the middle of it is still told from its ends.
const DEEPEST: u32 = 52;

/// The integral of |v0 + v1 s + v2 s²| from -1 to 1 by Gauss and Legendre, eight points (Abramowitz and Stegun, table
/// 25.4).
fn gauss(v0: [f64; 3], v1: [f64; 3], v2: [f64; 3]) -> f64 {
    const POINTS: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_3),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
        (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
    ];
    let speed = |s: f64| {
        let v: [f64; 3] = std::array::from_fn(|i| v0[i] + s * (v1[i] + s * v2[i]));
        dot(v, v).sqrt()
    };
    POINTS.iter().map(|&(s, weight)| weight * (speed(s) + speed(-s))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: x = 3t, y = 3t (3t - 1)(3t - 2) runs through (0, 0), (1, 0), (2, 0) and (3, 6); it leaves with (3, 6).
    #[test]
    fn four_points_make_a_cubic() {
        let curve = Cubic::through([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [2.0, 0.0, 1.0], [3.0, 6.0, 1.0]]);
        assert_eq!(curve.control, [[1.0, 2.0, 1.0], [2.0, -5.0, 1.0]]);
        assert_eq!(curve.coefficients().a, [3.0, 6.0, 0.0]);
        // dy/dx = 3x² - 6x + 2 is 0 at x = 1 ± 1/√3.
        let turns: Vec<f64> = curve.turns(1).map(|t| 3.0 * t).collect();
        let apart = 1.0 / 3f64.sqrt();
        assert!((turns[0] - 1.0 - apart).abs() < 1e-15 && (turns[1] - 1.0 + apart).abs() < 1e-15, "{turns:?}");
        assert_eq!(curve.turns(0).count() + curve.turns(2).count(), 0);
    }

    /// A straight line at an even pace; one that runs 1 back and forth at each end; the semicubical parabola y² = x³,
    /// whose length from the cusp is ((4 + 9x)^1.5 - 8)/27; and a curve that Simpson's rule measures over many panels.
    #[test]
    fn lengths() {
        let line = Cubic::through([[0.0; 3], [1.0, 2.0, 2.0], [2.0, 4.0, 4.0], [3.0, 6.0, 6.0]]);
        assert_eq!(line.length(), 9.0);
        let cusp = Cubic {
            start: [1.0, -1.0, 0.0],
            control: [[-1.0 / 3.0, 1.0, 0.0], [-1.0 / 3.0, -1.0, 0.0]],
            end: [1.0, 1.0, 0.0],
        };
        let long = 2.0 * (13.0 * 13f64.sqrt() - 8.0) / 27.0;
        assert!((cusp.length() - long).abs() < 1e-12 * long, "{} {long}", cusp.length());
        let curve = Cubic::through([[0.0; 3], [10.0, 30.0, 5.0], [40.0, -20.0, 1.0], [50.0, 0.0, 9.0]]);
        let Coefficients { a, b, c } = curve.coefficients();
        let speed = |t: f64| norm(std::array::from_fn(|i| a[i] + t * (2.0 * b[i] + t * 3.0 * c[i])));
        let panels = 20_000;
        let odd: f64 = (0..panels).map(|i| speed((2 * i + 1) as f64 / (2 * panels) as f64)).sum();
        let even: f64 = (1..panels).map(|i| speed(i as f64 / panels as f64)).sum();
        let simpson = (speed(0.0) + speed(1.0) + 4.0 * odd + 2.0 * even) / (6 * panels) as f64;
        assert!((curve.length() - simpson).abs() < 1e-12 * simpson, "{} {simpson}", curve.length());
        assert_eq!(Cubic { start: [7.0; 3], control: [[7.0; 3]; 2], end: [7.0; 3] }.length(), 0.0);
    }
}
