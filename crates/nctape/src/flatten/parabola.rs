//! Parabolas: as few chords with their ends on the curve as keep the tolerance.

use crate::execute::circle::length;
use crate::execute::parabola::{Parabola, cross, dot, norm};

/// Gives the points between the ends.
///
/// The line through the chord of [t1, t2] is off the curve by exactly E = (t2 - t1)² k / (2 |B'((t1 + t2) / 2)|), with
/// k = |A × D| and B'(t) = 2 (A + tD): the chord is parallel to the tangent at the middle parameter. So the longest step
/// of h from t within the tolerance e solves h² k = 2 e |B'(t) + hD|, and greedy steps are the fewest. Only at a sharp
/// turn, where the curve runs beyond the ends of its chord, is a step shorter than that. The tolerance is then narrowed
/// until the last step is as full as the others, so that the points lie evenly.
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
    if count >= most {
        // The tolerance cannot be kept, and the steps would end before the curve does: as many even ones as allowed.
        for index in 1..count {
            give(curve.point(index as f64 / count as f64));
        }
        return;
    }
    let (mut low, mut high) = (0.0, tolerance);
    // Evenness is for the eye: a hundredth of the tolerance is enough of it, and that is seven halvings.
    let halvings = if count <= EVENED { 7 } else { 0 };
    for _ in 0..halvings {
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
        give(curve.point(t));
    }
}

/// The most chords among which the last step is evened out: among more, no eye finds it.
const EVENED: usize = 256;

/// How near a step comes to the longest one that fits, as a part of it. Far below what changes a count of steps.
const STEP_PRECISION: f64 = 1e-9;

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

    /// The longest step from t within a tolerance: the root of h² k = 2 e |B'(t) + hD|, no longer than to the end, and
    /// shorter where the curve would run too far beyond the ends of its chord.
    ///
    /// The step fits whatever happens; that it is the longest holds to [`STEP_PRECISION`].
    fn step(&self, t: f64, tolerance: f64) -> f64 {
        // Negative where the step fits. |B'(t) + hD| is |B'| at t + h/2.
        let excess = |h: f64| h * h * self.k - 2.0 * tolerance * self.speed(t + h / 2.0);
        let overruns = |h: f64| self.overrun(t, h) > tolerance;
        let rest = 1.0 - t;
        let (mut low, mut high) = (0.0, rest);
        let mut above = excess(rest);
        if above > 0.0 {
            // False position, with the Illinois rule against an end that stays (Dowell and Jarratt, 1971). It takes
            // some eight rounds; the limit is for curves at the edge of what f64 can hold.
            let mut below = excess(0.0);
            for _ in 0..100 {
                if below >= 0.0 || high - low <= STEP_PRECISION * high {
                    break;
                }
                let between = (low * above - high * below) / (above - below);
                let value = excess(between);
                if value > 0.0 {
                    (high, above, below) = (between, value, below / 2.0);
                } else {
                    (low, below, above) = (between, value, above / 2.0);
                }
            }
        } else {
            low = rest;
        }
        if overruns(low) {
            (low, high) = (0.0, low);
            while high - low > STEP_PRECISION * high {
                let middle = (low + high) / 2.0;
                if excess(middle) > 0.0 || overruns(middle) { high = middle } else { low = middle }
            }
        }
        low
    }

    /// How far, at most, the curve from t to t + h is from the ends of its chord where it runs beyond them.
    ///
    /// In the piece's own parameter s the point is 2s A' + s² D', with A' = h (A + tD) and D' = h² D. Along the chord
    /// that is 2s a + s² d; it is behind the start up to s = -2a/d, at most by a²/d, and beside the chord by
    /// 2s (1 - s) |A'⊥|, which grows up to s = 1/2. The end is the start of the same piece run backwards.
    fn overrun(&self, t: f64, h: f64) -> f64 {
        let first: [f64; 3] = std::array::from_fn(|i| h * (self.a[i] + t * self.d[i]));
        let second = self.d.map(|component| h * h * component);
        let chord: [f64; 3] = std::array::from_fn(|i| 2.0 * first[i] + second[i]);
        let reach = norm(chord);
        if reach == 0.0 {
            return f64::INFINITY;
        }
        let last: [f64; 3] = std::array::from_fn(|i| -(first[i] + second[i]));
        let (d, beside) = (dot(second, chord) / reach, norm(cross(first, chord)) / reach);
        let behind = |a: f64, d: f64| {
            if a >= 0.0 {
                return 0.0;
            }
            // Beside the chord it is furthest at s = 1/2, if the run goes on that long.
            let s = f64::min(-2.0 * a / d, 0.5);
            length([a * a / d, 2.0 * s * (1.0 - s) * beside])
        };
        let (start, end) = (dot(first, chord) / reach, -dot(last, chord) / reach);
        f64::max(behind(start, d), behind(end, -d))
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
