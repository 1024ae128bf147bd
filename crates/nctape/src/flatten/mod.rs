//! From spans to points: polylines that keep a tolerance with few points.
//!
//! Every span gives its start, points on the curve, and its end: the last point is the programmed one bit for bit.

mod arc;
mod cubic;
mod parabola;

use crate::execute::cubic::Cubic;
use crate::span::{Geometry, Span};
use std::ops::Range;

/// The most chords of one span. It is beyond what any picture shows: on a full circle it keeps a tolerance of
/// 1,1e-9 radii. A finer tolerance is not kept; without a limit a radius of a few kilometres and a tolerance of a
/// picometre would take all memory.
pub const MOST_CHORDS: usize = 1 << 16;

/// The most points of a whole tape, for the same reason: about 200 MB of coordinates. Beyond it a span gives its
/// ends only.
pub const MOST_POINTS: usize = 1 << 23;

/// Points of a path: `span[i]` is the span of the i-th point, whose X, Y and Z are `xyz[3 * i..]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Points {
    /// X, Y and Z of every point in the unit of the format.
    pub xyz: Vec<f64>,
    /// The span of every point.
    pub span: Vec<u32>,
}

/// Flattens some of the spans. No point of a curve is further from its polyline than `tolerance`, a positive length in the unit
/// of the format.
pub fn flatten(spans: &[Span], range: Range<usize>, tolerance: f64) -> Points {
    let mut points = Points::default();
    for (index, span) in spans.iter().enumerate().take(range.end).skip(range.start) {
        let most = if points.span.len() < MOST_POINTS { MOST_CHORDS } else { 1 };
        span_points(span, tolerance, most, &mut |point| {
            points.xyz.extend_from_slice(&point);
            points.span.push(index as u32);
        });
    }
    points
}

/// Gives the points of one span, its start first and its end last. No point of its curve is further from the lines
/// between them than `tolerance`, a positive length in the unit of the format; nothing is allocated.
pub fn flatten_span(span: &Span, tolerance: f64, give: &mut impl FnMut([f64; 3])) {
    span_points(span, tolerance, MOST_CHORDS, give);
}

fn span_points(span: &Span, tolerance: f64, most: usize, give: &mut impl FnMut([f64; 3])) {
    give(span.start);
    match span.geometry {
        Geometry::Line => {}
        Geometry::Arc(arc) => arc::inner_points(&arc, span.start, span.end, tolerance, most, give),
        Geometry::Parabola { tangent } => {
            parabola::inner_points(span.start, tangent, span.end, tolerance, most, give);
        }
        Geometry::Curve { control } => {
            cubic::inner_points(&Cubic { start: span.start, control, end: span.end }, tolerance, most, give);
        }
    }
    give(span.end);
}
