//! Cubics: greedy chords with their ends on the curve, each as long as is sure to keep the tolerance.

use crate::execute::cubic::{Coefficients, Cubic};
use crate::execute::parabola::{dot, norm};

/// Gives the points between the ends.
///
/// The distance from a chord is a convex function of the place, so a piece of the curve is no further from its chord
/// than the same mixture of the distances of its control points: 3s(1-s)((1-s)α + sβ), the greatest value of which is
/// known. Where the piece bends one way only, as nearly all pieces do, that is the distance itself, and the greedy
/// steps are the fewest: about ∫ √(curvature / 8e) ds of them. A piece with an inflection is a little shorter than it
/// might be.
pub(super) fn inner_points(curve: &Cubic, tolerance: f64, most: usize, give: &mut impl FnMut([f64; 3])) {
    let steps = Steps { of: curve.coefficients(), tolerance };
    let count = steps.run(most, &mut |_| {});
    if count >= most {
        // The tolerance cannot be kept, and the steps would end before the curve does: as many even ones as allowed.
        for index in 1..count {
            give(curve.point(index as f64 / count as f64));
        }
        return;
    }
    steps.run(most, &mut |t| give(curve.point(t)));
}

/// How near a step comes to the longest one that fits, as a part of it: far below what changes a count of steps.
const STEP_PRECISION: f64 = 1e-6;

struct Steps {
    of: Coefficients,
    tolerance: f64,
}

impl Steps {
    /// Gives the parameters between the steps; tells how many steps there are, at most `most`.
    fn run(&self, most: usize, give: &mut impl FnMut(f64)) -> usize {
        let (mut t, mut last) = (0.0, 1.0);
        for count in 1..most {
            let step = self.step(t, last);
            // A step too small to change t would never reach the end.
            if step <= 0.0 || t + step <= t {
                return most.max(1);
            }
            t += step;
            last = step;
            if t >= 1.0 {
                return count;
            }
            give(t);
        }
        most.max(1)
    }

    /// A step from t that fits, as long as it may be; sought from a guess on.
    fn step(&self, t: f64, guess: f64) -> f64 {
        let rest = 1.0 - t;
        // Above zero where the step does not fit; like h - 1, so that the secant finds its zero soon.
        let excess = |h: f64| (self.bound(t, h) / self.tolerance).sqrt() - 1.0;
        let mut low = (0.0, -1.0);
        let mut high = (guess.min(rest), 0.0);
        high.1 = excess(high.0);
        while high.1 <= 0.0 {
            if high.0 >= rest {
                return rest;
            }
            low = high;
            // Twice as long at most: nothing that bends is leapt over.
            let wanted = if high.1 > -0.5 { 1.0 / (1.0 + high.1) * 1.01 } else { 2.0 };
            high.0 = (high.0 * wanted.min(2.0)).min(rest);
            high.1 = excess(high.0);
        }
        // False position, with the Illinois rule against an end that stays (Dowell and Jarratt, 1971).
        let mut side = 0;
        for _ in 0..100 {
            if high.0 - low.0 <= STEP_PRECISION * high.0 {
                break;
            }
            // Aimed a trace short of the zero, at the end that counts.
            let between = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1) - STEP_PRECISION / 4.0 * high.0;
            let between = if between > low.0 && between < high.0 { between } else { (low.0 + high.0) / 2.0 };
            let value = excess(between);
            if value > 0.0 {
                high = (between, value);
                if side > 0 {
                    low.1 /= 2.0;
                }
                side = 1;
            } else {
                low = (between, value);
                // A trace below the tolerance is as good as on it.
                if value > -STEP_PRECISION {
                    break;
                }
                if side < 0 {
                    high.1 /= 2.0;
                }
                side = -1;
            }
        }
        low.0
    }

    /// How far, at most, the curve from t to t + h is from its chord.
    fn bound(&self, t: f64, h: f64) -> f64 {
        let Coefficients { a, b, c } = self.of;
        let velocity = |t: f64| -> [f64; 3] { std::array::from_fn(|i| a[i] + t * (2.0 * b[i] + t * 3.0 * c[i])) };
        let (from, to) = (velocity(t), velocity(t + h));
        let chord: [f64; 3] = std::array::from_fn(|i| h * (from[i] + h * (b[i] + 3.0 * t * c[i] + h * c[i])));
        let square = dot(chord, chord);
        // The distance of a place from the chord, both counted from the start of the piece.
        let off = |place: [f64; 3]| {
            let part = if square > 0.0 { (dot(place, chord) / square).clamp(0.0, 1.0) } else { 0.0 };
            norm(std::array::from_fn(|i| place[i] - part * chord[i]))
        };
        let (first, last) = (off(from.map(|v| v * h / 3.0)), off(std::array::from_fn(|i| chord[i] - to[i] * h / 3.0)));
        let (more, less) = (f64::max(first, last), f64::min(first, last));
        if more == 0.0 {
            return 0.0;
        }
        // The zero of the derivative of 3s(1-s)((1-s)α + sβ), α ≥ β.
        let s = more / (2.0 * more - less + (more * more - more * less + less * less).sqrt());
        3.0 * s * (1.0 - s) * ((1.0 - s) * more + s * less)
    }
}
