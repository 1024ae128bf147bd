//! Arcs: as circles, as parabolas, as chords.

use super::Arcs;
use super::motion::Rate;
use super::posting::Poster;
use crate::cldata::step::Motion;
use crate::format::Standard;
use crate::format::power_of_ten;
use crate::rules::{conversion, posting as rules};
use crate::span::Arc;
use crate::write::{Course, Fault, Move};
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Straight cuts of a whole tape at the most: some 40 MB of text.
const MOST_CHORDS: usize = 1 << 20;

/// An arc in the unit of the format, with its third axis.
struct Course3 {
    arc: Arc,
    from: [f64; 3],
    to: [f64; 3],
}

impl Course3 {
    /// The point at a share of the angle. The ends are those of the text to the bit.
    fn at(&self, share: f64) -> [f64; 3] {
        if share >= 1.0 {
            return self.to;
        }
        let Arc { plane, centre, start_radius, end_radius, start_angle, sweep } = self.arc;
        let [first, second, third] = plane.axes();
        let radius = start_radius + share * (end_radius - start_radius);
        let (sine, cosine) = libm::sincos(start_angle + share * sweep);
        let mut point = self.from;
        point[first] = centre[0] + radius * cosine;
        point[second] = centre[1] + radius * sine;
        point[third] += share * (self.to[third] - self.from[third]);
        point
    }

    /// The length of a share of it.
    fn length(&self, share: f64) -> f64 {
        let third = self.arc.plane.axes()[2];
        share * libm::hypot(self.arc.length_in_plane(), self.to[third] - self.from[third])
    }

    fn radius(&self) -> f64 {
        self.arc.start_radius.max(self.arc.end_radius)
    }
}

impl Poster<'_> {
    pub(super) fn arc(&mut self, arc: &Arc, motion: &Motion, rate: Rate, place: Range<usize>) {
        if self.control.standard() == Standard::Iso1058 {
            self.take(Err(Fault::NoContouring), place);
            return;
        }
        let (from, to) = (self.point(motion.from.unwrap_or(motion.to)), self.point(motion.to));
        // After points that were not put out (DNTCUT), or a gap, the tool stands elsewhere.
        let is_there = (0..3).all(|axis| self.stands_at(axis, from[axis]));
        if !is_there
            && !(if motion.rapid { self.rapid(from, place.clone()) } else { self.cut(from, rate, place.clone()) })
        {
            return;
        }
        if motion.rapid {
            // Positioning goes straight; the way of an arc at rapid traverse is nobody's.
            self.rapid(to, place);
            return;
        }
        let centre = arc.centre.map(|value| self.length(value));
        let [start_radius, end_radius] = [arc.start_radius, arc.end_radius].map(|radius| self.length(radius));
        let course = Course3 { arc: Arc { centre, start_radius, end_radius, ..*arc }, from, to };
        let [first, second, third] = arc.plane.axes();
        let is_helix = !self.stands_at(third, to[third]);
        let places = self.control.axes[first].decimals.min(self.control.axes[second].decimals);
        let increment = 1.0 / power_of_ten(places) as f64;
        let chord = libm::hypot(
            self.writer.nearest(first, to[first]) - self.writer.position(first),
            self.writer.nearest(second, to[second]) - self.writer.position(second),
        );
        let whole = arc.sweep.abs();
        // Its ends are the same or neighbours on the tape: it would be read as a full circle or the rest of one.
        let is_closed = chord <= 2.0 * increment;
        if is_closed && whole < PI {
            self.cut(to, rate, place);
            return;
        }
        match self.arcs {
            // A circle of a few increments is none on the tape.
            _ if course.radius() <= 4.0 * increment => self.chords(&course, increment / 2.0, rate, place),
            Arcs::Circles if is_helix && !self.control.helix => {
                let message = format!(
                    "The third axis moves along this arc, which the control does not do: it is written as straight cuts \
                     within {}.",
                    self.tolerance
                );
                self.report(&conversion::curve_as_chords::RULE, "helix", place.clone(), message);
                self.chords(&course, self.tolerance, rate, place);
            }
            Arcs::Circles => {
                let full = self.control.format.itemized.full_circle == Some(true);
                let parts = match whole {
                    _ if whole > TAU * (1.0 + 1e-9) || is_closed && !(full && chord == 0.0) => (whole / PI).ceil(),
                    _ => 1.0,
                };
                // Three points on so flat an arc say a line.
                let flat = course.radius() * (1.0 - libm::cos((whole / parts).min(PI) / 2.0)) <= 3.0 * increment;
                if flat && !self.writer.arcs_by_centre(arc.plane) {
                    self.chords(&course, increment / 2.0, rate, place);
                } else {
                    self.circles(&course, parts.max(1.0), rate, place);
                }
            }
            Arcs::Parabolas if is_helix => self.chords(&course, self.tolerance, rate, place),
            Arcs::Parabolas => {
                let parts = (whole / parabola_angle(self.tolerance, course.radius())).ceil().max(1.0);
                let flat = course.radius() * (1.0 - libm::cos(whole / parts / 2.0)) <= 3.0 * increment;
                if flat {
                    self.chords(&course, increment / 2.0, rate, place);
                } else {
                    self.parabolas(&course, parts, rate, place);
                }
            }
            Arcs::Chords => self.chords(&course, self.tolerance, rate, place),
        }
    }

    fn circles(&mut self, course: &Course3, parts: f64, rate: Rate, place: Range<usize>) {
        let Arc { plane, centre, sweep, .. } = course.arc;
        self.pieces(course, parts, place, |poster, to| {
            let course_of_piece = Course::Arc { plane, centre, sweep: sweep / parts };
            let pace = poster.pace(rate, course.length(1.0 / parts));
            poster.writer.motion(&Move { course: course_of_piece, end: poster.named(to), pace })
        });
    }

    fn parabolas(&mut self, course: &Course3, parts: f64, rate: Rate, place: Range<usize>) {
        let mut share = 0.0;
        let third = course.arc.plane.axes()[2];
        self.pieces(course, parts, place, |poster, to| {
            let middle = course.at(share + 0.5 / parts);
            share += 1.0 / parts;
            // By the ends as the tape has them, so that the point opposite the chord's middle is the arc's.
            let tangent = std::array::from_fn(|axis| {
                let start = poster.writer.position(axis);
                if axis == third {
                    start
                } else {
                    2.0 * middle[axis] - (start + poster.writer.nearest(axis, to[axis])) / 2.0
                }
            });
            let pace = poster.pace(rate, course.length(1.0 / parts));
            poster.writer.motion(&Move { course: Course::Parabola { tangent }, end: poster.named(to), pace })
        });
    }

    /// Writes an arc in equal pieces.
    fn pieces(
        &mut self,
        course: &Course3,
        parts: f64,
        place: Range<usize>,
        mut write: impl FnMut(&mut Self, [f64; 3]) -> Result<(), Fault>,
    ) {
        let mut part = 1.0;
        while part <= parts {
            let is_last = part == parts;
            let rounding = self.writer.rounding;
            let written = write(self, course.at(if is_last { 1.0 } else { part / parts }));
            if !is_last {
                // A point that the format makes necessary lies on no increment, and no one has given it.
                self.writer.rounding = rounding;
            }
            if !self.take(written, place.clone()) {
                return;
            }
            self.said_axes();
            part += 1.0;
        }
    }

    /// Straight cuts from point to point on the arc, which is nowhere further off than a tolerance.
    fn chords(&mut self, course: &Course3, tolerance: f64, rate: Rate, place: Range<usize>) {
        let parts = (course.arc.sweep.abs() / chord_angle(tolerance, course.radius())).ceil().max(1.0);
        if parts > (MOST_CHORDS - self.chords) as f64 {
            let message = "This arc would take too many straight cuts: a coarser tolerance takes fewer.";
            self.lack(&rules::motion_not_posted::RULE, message, place, message.to_owned());
            return;
        }
        self.chords += parts as usize;
        let mut part = 1.0;
        while part <= parts {
            let is_last = part == parts;
            let rounding = self.writer.rounding;
            if !self.cut(course.at(if is_last { 1.0 } else { part / parts }), rate, place.clone()) {
                return;
            }
            if !is_last {
                self.writer.rounding = rounding;
            }
            part += 1.0;
        }
    }
}

/// The angle of an arc that a chord keeps within a tolerance: the height of the arc over it, R (1 - cos a/2).
fn chord_angle(tolerance: f64, radius: f64) -> f64 {
    2.0 * libm::acos((1.0 - tolerance / radius).clamp(-0.5, 1.0))
}

/// The angle of an arc that the parabola through its ends and its middle keeps within a tolerance.
///
/// With c = 1 - cos a/2 and u from -1 to 1 along the chord, the square of the distance from the centre is
/// R² (1 - c² u² (1 - u²)), least at u² = 1/2: the parabola lies inside, by R (1 - √(1 - c²/4)) at most. For R = 20 and
/// 0,01 that is 40,97 degrees, with which the parabolic tape of ISO 2539 annex E needs the three and two spans that it
/// has.
fn parabola_angle(tolerance: f64, radius: f64) -> f64 {
    let inside = (1.0 - tolerance / radius).clamp(0.0, 1.0);
    let versine = (2.0 * (1.0 - inside * inside).sqrt()).min(1.0);
    2.0 * libm::acos(1.0 - versine)
}
