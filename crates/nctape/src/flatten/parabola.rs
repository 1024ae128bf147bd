//! Parabolas: as few chords with their ends on the curve as keep the tolerance.

use crate::execute::parabola::Parabola;
use crate::execute::parabola::norm;

/// Gives the points between the ends.
///
/// The chord of [t1, t2] is off the curve by exactly E = (t2 - t1)² k / (2 |B'((t1 + t2) / 2)|), with k = |A × D| and
/// B'(t) = 2 (A + tD): the chord is parallel to the tangent at the middle parameter. So the longest step of h from t
/// within the tolerance e solves h² k = 2 e |B'(t) + hD|, and greedy steps are the fewest. The tolerance is then
/// narrowed until the last step is as full as the others, so that the points lie evenly.
pub(super) fn inner_points(
    start: [f64; 3],
    tangent: [f64; 3],
    end: [f64; 3],
    tolerance: f64,
    most: usize,
    give: &mut impl FnMut([f64; 3]),
) {
    let curve = Parabola { start, tangent, end };
    let flattening = Flattening { a: curve.a(), d: curve.d(), k: curve.k() };
    let count = flattening.count(tolerance, most);
    let (mut low, mut high) = (0.0, tolerance);
    // Forty halvings narrow the tolerance to the last digits that change a point.
    for _ in 0..40 {
        let middle = (low + high) / 2.0;
        if flattening.count(middle, count + 1) > count { low = middle } else { high = middle }
    }
    let mut t = 0.0;
    for _ in 1..count {
        t += flattening.step(t, high);
        // Rounding may bring the last of the even steps to the end; the end itself is given elsewhere.
        if t >= 1.0 {
            break;
        }
        let s = 1.0 - t;
        give(std::array::from_fn(|i| s * s * start[i] + 2.0 * t * s * tangent[i] + t * t * end[i]));
    }
}

struct Flattening {
    a: [f64; 3],
    d: [f64; 3],
    k: f64,
}

impl Flattening {
    /// |B'(t)|.
    fn speed(&self, t: f64) -> f64 {
        2.0 * norm(std::array::from_fn(|i| self.a[i] + t * self.d[i]))
    }

    /// The longest step from t within a tolerance: the root of h² k = 2 e |B'(t) + hD|, no longer than to the end.
    ///
    /// At h = 0 the right side is the larger; |B'(t) + hD| is |B'| at t + h/2.
    fn step(&self, t: f64, tolerance: f64) -> f64 {
        let fits = |h: f64| h * h * self.k <= 2.0 * tolerance * self.speed(t + h / 2.0);
        let rest = 1.0 - t;
        if fits(rest) {
            return rest;
        }
        let (mut low, mut high) = (0.0, rest);
        // 52 halvings reach the last bit of h.
        for _ in 0..52 {
            let middle = (low + high) / 2.0;
            if fits(middle) { low = middle } else { high = middle }
        }
        low
    }

    /// Greedy steps to the end, at most `most`.
    fn count(&self, tolerance: f64, most: usize) -> usize {
        let mut t = 0.0;
        for count in 1..most {
            let step = self.step(t, tolerance);
            t += step;
            // A step too small to change t would never reach the end.
            if t >= 1.0 || step <= 0.0 {
                return count;
            }
        }
        most.max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(start: [f64; 2], tangent: [f64; 2], end: [f64; 2], tolerance: f64) -> usize {
        let mut points = 0;
        let lift = |p: [f64; 2]| [p[0], p[1], 0.0];
        inner_points(lift(start), lift(tangent), lift(end), tolerance, usize::MAX, &mut |_| points += 1);
        points + 1
    }

    /// Counts worked out apart from this crate, by the integral of the curvature.
    #[test]
    fn counts_are_the_fewest() {
        assert_eq!(count([0.0, 0.0], [50.0, 1.0], [0.0, 2.0], 0.01), 13);
        assert_eq!(count([0.0, 0.0], [5.0, 60.0], [100.0, 0.0], 0.01), 51);
        assert_eq!(count([0.0, 0.0], [50.0, 100.0], [100.0, 0.0], 0.001), 189);
        assert_eq!(count([0.0, 0.0], [50.0, 0.0], [100.0, 0.0], 0.001), 1);
    }
}
