//! The path of the cutter's centre where cutter compensation is in force (clause 5; G41 and G42 of ISO 1056).
//!
//! The standard leaves the geometry to the builder. What is drawn here is the plain case:
//!
//! - Under G41 and G42 every line and arc is moved sideways in the plane by the radius of the cutter. At an outside
//!   corner the pieces are joined by an arc about the corner, at an inside corner they end where they meet.
//! - A vector P, Q, R moves the start of its span by the radius in its direction and keeps its angle to the path along
//!   the span, turning with an arc or a parabola; spans are joined by straight lines.
//!
//! Real controls differ: in how they come to the compensated path in the first block and leave it in the last one (here
//! both are full spans), in the joint of an outside corner (some go on to the intersection), in how many blocks they
//! look ahead, and in what they do behind a move along the third axis (here each stretch begins anew).
//!
//! Nothing is drawn wrong in silence: where the cutter does not fit, or the geometry is not worked out, the piece is
//! left out and told as a [`Fault`].

mod corner;
mod piece;
mod vector;

use crate::format::Plane;
use crate::span::{Geometry, Offset, Span, Spans};
use corner::Joint;
use piece::Piece;

/// The path of the cutter's centre as points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OffsetPath {
    /// X, Y and Z of every point in the unit of the format.
    pub xyz: Vec<f64>,
    /// The span to which every point belongs; a joint belongs to the span behind it.
    pub span: Vec<u32>,
    /// The points at which a stretch begins that does not go on from the point before.
    pub starts: Vec<u32>,
    /// What was left out.
    pub faults: Vec<Fault>,
}

/// A span whose offset is not drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// The span.
    pub span: usize,
    /// Why.
    pub kind: FaultKind,
}

/// Why the offset of a span is not drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FaultKind {
    /// The radius of the cutter is not smaller than that of an inside arc.
    InsideArc {
        /// The radius of the arc; `None` for the bend of another curve.
        radius: Option<f64>,
    },
    /// The pieces on both sides of an inside corner, at the start of the span, do not meet.
    InsideCorner,
    /// Nothing is left of the span between the inside corners at its ends.
    TooShort,
    /// What has no offset here: a curve that is no line, arc or parabola, or an inside corner beside a parabola.
    NotWorkedOut,
}

impl OffsetPath {
    fn begin(&mut self) {
        self.starts.push(self.span.len() as u32);
    }

    fn give(&mut self, span: usize, point: [f64; 3]) {
        self.xyz.extend_from_slice(&point);
        self.span.push(span as u32);
    }

    fn fault(&mut self, span: usize, kind: FaultKind) {
        self.faults.push(Fault { span, kind });
    }

    fn last(&self) -> Option<[f64; 3]> {
        self.xyz.last_chunk().copied()
    }
}

/// The path of a cutter's centre. No point of it is further from its curve than `tolerance`; `step` is the least input
/// increment, by which the ends of the programmed path may be rounded. `None` where no compensation is in force.
pub(crate) fn offset_path(spans: &Spans, radius: f64, step: f64, tolerance: f64) -> Option<OffsetPath> {
    let offsets = spans.offsets();
    if offsets.iter().all(|offset| *offset == Offset::None) {
        return None;
    }
    let mut path = OffsetPath::default();
    let mut index = 0;
    while index < offsets.len() {
        let first = index;
        index += 1;
        while index < offsets.len() && goes_on(&spans.list, offsets, index) {
            index += 1;
        }
        match offsets[first] {
            Offset::None => {}
            Offset::Along(_) => vector::stretch(&spans.list, offsets, first..index, radius, tolerance, &mut path),
            Offset::Left(plane) => stretch(&spans.list, first..index, (plane, radius), step, tolerance, &mut path),
            Offset::Right(plane) => stretch(&spans.list, first..index, (plane, -radius), step, tolerance, &mut path),
        }
    }
    Some(path)
}

/// A span goes on from the one before it under the same kind of offset.
fn goes_on(spans: &[Span], offsets: &[Offset], index: usize) -> bool {
    let alike = match (offsets[index - 1], offsets[index]) {
        (Offset::Along(_), Offset::Along(_)) => true,
        (before, this) => before == this,
    };
    alike && spans[index - 1].end == spans[index].start
}

/// A stretch under G41 or G42. `left` is the radius, to the left of the motion: negative to the right.
fn stretch(
    spans: &[Span],
    range: std::ops::Range<usize>,
    (plane, left): (Plane, f64),
    step: f64,
    tolerance: f64,
    path: &mut OffsetPath,
) {
    let mut run: Vec<Piece> = Vec::new();
    for index in range {
        let span = &spans[index];
        if is_upright(span, plane) {
            draw(&mut run, left, step, tolerance, path);
            // Along the third axis the cutter stands where it stood; before the first piece it is not known where.
            if let Some(mut point) = path.last().filter(|_| path.span.last() == Some(&(index.wrapping_sub(1) as u32))) {
                point[plane.axes()[2]] = span.end[plane.axes()[2]];
                path.give(index, point);
            }
            continue;
        }
        match Piece::of(span, index, plane, left) {
            Ok(piece) => run.push(piece),
            Err(kind) => {
                draw(&mut run, left, step, tolerance, path);
                path.fault(index, kind);
            }
        }
    }
    draw(&mut run, left, step, tolerance, path);
}

/// The span moves along the third axis of the plane alone.
fn is_upright(span: &Span, plane: Plane) -> bool {
    let [first, second, _] = plane.axes();
    span.geometry == Geometry::Line && span.start[first] == span.end[first] && span.start[second] == span.end[second]
}

/// Joins the pieces of a stretch and gives their points; what does not fit is left out.
fn draw(run: &mut Vec<Piece>, left: f64, step: f64, tolerance: f64, path: &mut OffsetPath) {
    let mut pieces = std::mem::take(run);
    let mut joints = Vec::with_capacity(pieces.len());
    for at in 1..pieces.len() {
        let (before, behind) = pieces.split_at_mut(at);
        let (Some(before), Some(this)) = (before.last_mut(), behind.first_mut()) else { continue };
        joints.push(corner::join(before, this, left, step));
    }
    let mut connected = false;
    for (at, piece) in pieces.iter().enumerate() {
        match at.checked_sub(1).map(|before| &joints[before]) {
            Some(Joint::Fault(kind)) => {
                path.fault(piece.span, *kind);
                connected = false;
            }
            Some(Joint::Around { corner, from, turn }) if connected => {
                let chords = piece::chords(left.abs(), *turn, tolerance);
                for chord in 1..chords {
                    let angle = from + turn * chord as f64 / chords as f64;
                    let point = [corner[0] + left * libm::cos(angle), corner[1] + left * libm::sin(angle)];
                    path.give(piece.span, piece.in_space(point, 0.0));
                }
            }
            _ => {}
        }
        if piece.leave <= piece.enter {
            path.fault(piece.span, FaultKind::TooShort);
            connected = false;
            continue;
        }
        if !connected {
            path.begin();
        }
        piece.points(tolerance, |point| path.give(piece.span, point));
        connected = true;
    }
}
