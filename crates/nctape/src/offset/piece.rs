//! One span moved sideways in a plane.

use super::FaultKind;
use crate::flatten::MOST_CHORDS;
use crate::format::Plane;
use crate::span::{Geometry, Span};

/// The offset of one span, between two places of it that corners may move.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub span: usize,
    plane: Plane,
    pub course: Course,
    /// The third axis at the start and at the end of the span.
    third: [f64; 2],
    /// Where the piece begins and ends, as shares of its course.
    pub enter: f64,
    pub leave: f64,
    /// The programmed end of the span, the directions in which it starts and ends, and the length by which its points
    /// say them.
    pub end: [f64; 2],
    pub tangents: [[f64; 2]; 2],
    pub reach: f64,
}

/// The course of an offset in its plane.
#[derive(Clone, Debug)]
pub(super) enum Course {
    Line {
        from: [f64; 2],
        to: [f64; 2],
    },
    Arc {
        centre: [f64; 2],
        radii: [f64; 2],
        angle: f64,
        sweep: f64,
    },
    /// The offset of a parabola, as points.
    Points(Vec<[f64; 2]>),
}

/// Chords of an arc whose sagitta keeps the tolerance; the on-curve optimum.
pub(super) fn chords(radius: f64, sweep: f64, tolerance: f64) -> usize {
    let share = (1.0 - tolerance / radius).clamp(-1.0, 1.0);
    // Half a turn in one chord would be no picture of an arc, however coarse.
    let most = (2.0 * libm::acos(share)).clamp(1e-9, std::f64::consts::FRAC_PI_2);
    ((sweep.abs() / most).ceil() as usize).clamp(1, MOST_CHORDS)
}

pub(super) fn unit(vector: [f64; 2]) -> Option<[f64; 2]> {
    let length = (vector[0] * vector[0] + vector[1] * vector[1]).sqrt();
    (length > 0.0).then(|| [vector[0] / length, vector[1] / length])
}

impl Piece {
    /// The offset of a span to the left of its motion; `left` is negative to the right.
    pub(super) fn of(span: &Span, index: usize, plane: Plane, left: f64) -> Result<Piece, FaultKind> {
        let [first, second, third] = plane.axes();
        let flat = |point: [f64; 3]| [point[first], point[second]];
        let (start, end) = (flat(span.start), flat(span.end));
        let aside = |point: [f64; 2], way: [f64; 2]| [point[0] - left * way[1], point[1] + left * way[0]];
        let (course, tangents, reach) = if span.geometry == Geometry::Line {
            let chord = [end[0] - start[0], end[1] - start[1]];
            let way = unit(chord).ok_or(FaultKind::NotWorkedOut)?;
            let line = Course::Line { from: aside(start, way), to: aside(end, way) };
            (line, [way, way], chord[0] * way[0] + chord[1] * way[1])
        } else if let Geometry::Arc(arc) = span.geometry
            && arc.plane == plane
        {
            // The centre lies to the left of an arc that turns counter-clockwise.
            let inwards = if arc.sweep > 0.0 { left } else { -left };
            let radii = [arc.start_radius - inwards, arc.end_radius - inwards];
            if radii[0] <= 0.0 || radii[1] <= 0.0 {
                return Err(FaultKind::InsideArc { radius: Some(arc.start_radius.min(arc.end_radius)) });
            }
            let tangent = |angle: f64| {
                let (cosine, sine) = (libm::cos(angle), libm::sin(angle));
                if arc.sweep > 0.0 { [-sine, cosine] } else { [sine, -cosine] }
            };
            let tangents = [tangent(arc.start_angle), tangent(arc.start_angle + arc.sweep)];
            let course = Course::Arc { centre: arc.centre, radii, angle: arc.start_angle, sweep: arc.sweep };
            (course, tangents, arc.start_radius)
        } else if let Geometry::Parabola { tangent } = span.geometry {
            parabola(start, flat(tangent), end, left)?
        } else {
            return Err(FaultKind::NotWorkedOut);
        };
        let third = [span.start[third], span.end[third]];
        Ok(Piece { span: index, plane, course, third, enter: 0.0, leave: 1.0, end, tangents, reach })
    }

    /// A point of the plane at a share of the course, in space.
    pub(super) fn in_space(&self, point: [f64; 2], share: f64) -> [f64; 3] {
        let [first, second, third] = self.plane.axes();
        let mut space = [0.0; 3];
        (space[first], space[second]) = (point[0], point[1]);
        space[third] = self.third[0] + share * (self.third[1] - self.third[0]);
        space
    }

    /// Gives its points, both ends included.
    pub(super) fn points(&self, tolerance: f64, mut give: impl FnMut([f64; 3])) {
        let chords = match &self.course {
            Course::Line { .. } => 1,
            Course::Arc { radii, sweep, .. } => {
                chords(radii[0].max(radii[1]), sweep * (self.leave - self.enter), tolerance)
            }
            Course::Points(points) => {
                let last = points.len() - 1;
                for (index, point) in points.iter().enumerate() {
                    give(self.in_space(*point, index as f64 / last as f64));
                }
                return;
            }
        };
        for chord in 0..=chords {
            let share = self.enter + (self.leave - self.enter) * chord as f64 / chords as f64;
            give(self.in_space(self.point(share), share));
        }
    }

    fn point(&self, share: f64) -> [f64; 2] {
        match &self.course {
            Course::Line { from, to } => std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis])),
            Course::Arc { centre, radii, angle, sweep } => {
                let (angle, radius) = (angle + share * sweep, radii[0] + share * (radii[1] - radii[0]));
                [centre[0] + radius * libm::cos(angle), centre[1] + radius * libm::sin(angle)]
            }
            Course::Points(points) => points[((points.len() - 1) as f64 * share) as usize],
        }
    }

    /// The share of the course at which a point of it lies.
    pub(super) fn share_of(&self, point: [f64; 2]) -> f64 {
        match &self.course {
            Course::Line { from, to } => {
                let (x, y) = (to[0] - from[0], to[1] - from[1]);
                ((point[0] - from[0]) * x + (point[1] - from[1]) * y) / (x * x + y * y)
            }
            Course::Arc { centre, angle, sweep, .. } => {
                let at = libm::atan2(point[1] - centre[1], point[0] - centre[0]);
                let turned = if *sweep > 0.0 { at - angle } else { angle - at };
                let turn = std::f64::consts::TAU;
                let turned = turned - (turned / turn).floor() * turn;
                // A trace before the start is no whole turn behind it.
                let turned = if turned > turn - 1e-9 { 0.0 } else { turned };
                turned / sweep.abs()
            }
            Course::Points(_) => 0.0,
        }
    }
}

/// The offset of a parabola: its points moved along the normal there. Where the curve bends more than the cutter they
/// run back, and the cutter does not fit.
#[allow(clippy::type_complexity)]
fn parabola(
    start: [f64; 2],
    middle: [f64; 2],
    end: [f64; 2],
    left: f64,
) -> Result<(Course, [[f64; 2]; 2], f64), FaultKind> {
    const CHORDS: usize = 64;
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(CHORDS + 1);
    let mut tangents = [[0.0; 2]; 2];
    for chord in 0..=CHORDS {
        let t = chord as f64 / CHORDS as f64;
        let s = 1.0 - t;
        let way = std::array::from_fn(|axis| s * (middle[axis] - start[axis]) + t * (end[axis] - middle[axis]));
        let way = unit(way).ok_or(FaultKind::NotWorkedOut)?;
        let at = |axis: usize| s * s * start[axis] + 2.0 * s * t * middle[axis] + t * t * end[axis];
        let point = [at(0) - left * way[1], at(1) + left * way[0]];
        if let Some(last) = points.last()
            && (point[0] - last[0]) * way[0] + (point[1] - last[1]) * way[1] <= 0.0
        {
            return Err(FaultKind::InsideArc { radius: None });
        }
        points.push(point);
        tangents[usize::from(chord > 0)] = way;
    }
    let reach = unit([middle[0] - start[0], middle[1] - start[1]])
        .map_or(0.0, |way| (middle[0] - start[0]) * way[0] + (middle[1] - start[1]) * way[1]);
    Ok((Course::Points(points), tangents, reach))
}
