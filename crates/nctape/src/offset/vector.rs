//! The offset by P, Q and R: a unit vector at the beginning of each span (clause 5).

use super::{FaultKind, OffsetPath, piece};
use crate::execute::parabola::{cross, dot, norm};
use crate::span::{Geometry, Offset, Span};
use std::ops::Range;

/// A stretch of spans, each moved by the radius in the direction of its vector.
pub(super) fn stretch(
    spans: &[Span],
    offsets: &[Offset],
    range: Range<usize>,
    radius: f64,
    tolerance: f64,
    path: &mut OffsetPath,
) {
    let mut connected = false;
    for index in range {
        let Offset::Along(vector) = offsets[index] else { continue };
        match points(&spans[index], vector, radius, tolerance) {
            Ok(points) => {
                if !connected {
                    path.begin();
                }
                points.into_iter().for_each(|point| path.give(index, point));
                connected = true;
            }
            Err(kind) => {
                path.fault(index, kind);
                connected = false;
            }
        }
    }
}

/// The offset of one span. The vector keeps its angle to the path: it turns with the curve.
fn points(span: &Span, vector: [f64; 3], radius: f64, tolerance: f64) -> Result<Vec<[f64; 3]>, FaultKind> {
    let moved = |point: [f64; 3], vector: [f64; 3]| std::array::from_fn(|axis| point[axis] + radius * vector[axis]);
    if span.geometry == Geometry::Line {
        return Ok(vec![moved(span.start, vector), moved(span.end, vector)]);
    }
    if let Geometry::Arc(arc) = span.geometry {
        let [first, second, third] = arc.plane.axes();
        let (cosine, sine) = (libm::cos(arc.start_angle), libm::sin(arc.start_angle));
        let outwards = vector[first] * cosine + vector[second] * sine;
        let along = vector[second] * cosine - vector[first] * sine;
        let radii = [arc.start_radius, arc.end_radius].map(|arc| arc + radius * outwards);
        if radii[0] <= 0.0 || radii[1] <= 0.0 {
            return Err(FaultKind::InsideArc { radius: Some(arc.start_radius.min(arc.end_radius)) });
        }
        let far = libm::hypot(radii[0].max(radii[1]), radius * along);
        let chords = piece::chords(far, arc.sweep, tolerance);
        let point = |chord: usize| {
            let share = chord as f64 / chords as f64;
            let angle = arc.start_angle + share * arc.sweep;
            let (cosine, sine) = (libm::cos(angle), libm::sin(angle));
            let (out, on) = (radii[0] + share * (radii[1] - radii[0]), radius * along);
            let mut point = [0.0; 3];
            point[first] = arc.centre[0] + out * cosine - on * sine;
            point[second] = arc.centre[1] + out * sine + on * cosine;
            let height = span.start[third] + share * (span.end[third] - span.start[third]);
            point[third] = height + radius * vector[third];
            point
        };
        return Ok((0..=chords).map(point).collect());
    }
    let Geometry::Parabola { tangent } = span.geometry else { return Err(FaultKind::NotWorkedOut) };
    const CHORDS: usize = 64;
    let a: [f64; 3] = std::array::from_fn(|axis| tangent[axis] - span.start[axis]);
    let b: [f64; 3] = std::array::from_fn(|axis| span.end[axis] - tangent[axis]);
    let unit = |vector: [f64; 3]| {
        let length = norm(vector);
        (length > 0.0).then(|| vector.map(|part| part / length)).ok_or(FaultKind::NotWorkedOut)
    };
    // The frame of the curve: along it, square to its plane, and square to both.
    let square = unit(cross(a, b))?;
    let frame = |way: [f64; 3]| Ok::<_, FaultKind>([unit(way)?, square, cross(square, unit(way)?)]);
    let parts = frame(a)?.map(|axis| dot(axis, vector));
    let mut points: Vec<[f64; 3]> = Vec::with_capacity(CHORDS + 1);
    for chord in 0..=CHORDS {
        let t = chord as f64 / CHORDS as f64;
        let s = 1.0 - t;
        let frame = frame(std::array::from_fn(|axis| s * a[axis] + t * b[axis]))?;
        let turned = std::array::from_fn(|axis| (0..3).map(|one| parts[one] * frame[one][axis]).sum());
        let at = |axis: usize| s * s * span.start[axis] + 2.0 * s * t * tangent[axis] + t * t * span.end[axis];
        let point: [f64; 3] = moved(std::array::from_fn(at), turned);
        if let Some(last) = points.last()
            && dot(std::array::from_fn(|axis| point[axis] - last[axis]), frame[0]) <= 0.0
        {
            return Err(FaultKind::InsideArc { radius: None });
        }
        points.push(point);
    }
    Ok(points)
}
