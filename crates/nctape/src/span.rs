//! Spans: the pieces of path that blocks make (4.1).

use crate::execute::Share;
use crate::execute::cubic::Cubic;
use crate::format::Plane;
use std::ops::Range;

/// What a span is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpanKind {
    /// Positioning under G00: the path is not controlled, it is drawn as a straight line.
    Rapid,
    /// A straight line at feed.
    Line,
    /// An arc in a principal plane.
    Arc,
    /// A parabola.
    Parabola,
    /// A curve of higher order.
    Curve,
    /// A dwell: no motion, only time. It is the one kind whose length is zero.
    Dwell,
}

impl SpanKind {
    /// Every kind, in the order of [`SpanKind::index`].
    pub const ALL: [SpanKind; 6] =
        [SpanKind::Rapid, SpanKind::Line, SpanKind::Arc, SpanKind::Parabola, SpanKind::Curve, SpanKind::Dwell];

    /// Its name in the interface.
    pub fn name(self) -> &'static str {
        match self {
            SpanKind::Rapid => "rapid",
            SpanKind::Line => "line",
            SpanKind::Arc => "arc",
            SpanKind::Parabola => "parabola",
            SpanKind::Curve => "curve",
            SpanKind::Dwell => "dwell",
        }
    }

    /// Its place in [`SpanKind::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }
}

/// The course of a span between its ends, in the unit of the format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Geometry {
    /// Straight.
    Line,
    /// About a centre in a principal plane; the third axis moves in proportion to the angle.
    Arc(Arc),
    /// The parabola whose tangents at the ends meet in this point: X, Y, Z.
    Parabola {
        /// The tangent intersection point.
        tangent: [f64; 3],
    },
    /// The cubic with these control points between its ends (Bézier): X, Y, Z of each.
    Curve {
        /// The control points.
        control: [[f64; 3]; 2],
    },
}

/// An arc about a centre.
///
/// Start, end and centre are whole increments, so the radii at the ends may differ by the rounding of the tape; the
/// radius then changes in proportion to the angle, so that the arc meets both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The plane that it lies in.
    pub plane: Plane,
    /// The centre: first and second axis of the plane.
    pub centre: [f64; 2],
    /// The radius at the start.
    pub start_radius: f64,
    /// The radius at the end.
    pub end_radius: f64,
    /// The angle of the start about the centre, in radians from the first axis towards the second.
    pub start_angle: f64,
    /// Radians, counter-clockwise positive as seen from the positive third axis.
    pub sweep: f64,
}

/// One span.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// What it is.
    pub kind: SpanKind,
    /// First and last block.
    pub blocks: (usize, usize),
    /// Its course.
    pub geometry: Geometry,
    /// Where X, Y and Z are at its start.
    pub start: [f64; 3],
    /// Where X, Y and Z are at its end: the programmed point to the bit.
    pub end: [f64; 3],
    /// Its length in the unit of the format: along X, Y and Z; where those stand still, along the axes parallel to them
    /// (U, V, W, and P, Q, R as tertiary motions, B.1); where those do, too, of the rotary axes, in turns or degrees.
    /// Zero of a dwell and of nothing else.
    pub length: f64,
    /// Rotary axes move alone: the length is an angle.
    pub angular: bool,
    /// Unit per minute along the path, and of a rotary axis that moves alone turns or degrees per minute (ISO 2539
    /// A.2.1); `None` where it is not known.
    pub feed: Option<f64>,
    /// `None` where it is not known.
    pub seconds: Option<f64>,
    /// It stands in for what could not be computed.
    pub substitute: bool,
}

/// How the cutter's centre lies off a span: by the cutter's radius in some direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Offset {
    /// On it.
    #[default]
    None,
    /// Left of the direction of motion in a plane, as seen from its positive third axis: G41.
    Left(Plane),
    /// Right of it: G42.
    Right(Plane),
    /// In the direction of this unit vector at the start of the span: P, Q and R (clause 5).
    Along([f64; 3]),
}

/// The spans of a tape, and where every axis is at the ends of each.
#[derive(Clone, Debug, Default)]
pub struct Spans {
    /// The spans, in order of execution.
    pub list: Vec<Span>,
    /// How many axes there are beside X, Y and Z.
    more: usize,
    /// Where those are at the start and at the end of each span, axis by axis.
    beyond: Vec<[f64; 2]>,
    shares: Vec<Share>,
    /// There is a cutter whose centre lies off the path: the offset of each span is kept.
    compensates: bool,
    offsets: Vec<Offset>,
}

impl Spans {
    pub(crate) fn new(axes: usize, compensates: bool) -> Spans {
        Spans { more: axes.saturating_sub(3), compensates, ..Spans::default() }
    }

    /// None, with as many axes and room for so many.
    pub(crate) fn empty(&self, room: usize) -> Spans {
        Spans {
            list: Vec::with_capacity(room),
            more: self.more,
            beyond: Vec::with_capacity(room * self.more),
            shares: Vec::with_capacity(room),
            compensates: self.compensates,
            offsets: Vec::with_capacity(if self.compensates { room } else { 0 }),
        }
    }

    /// Puts spans in the place of others.
    pub(crate) fn splice(&mut self, range: Range<usize>, others: Spans) {
        if range == (0..self.list.len()) {
            *self = others;
            return;
        }
        self.beyond.splice(range.start * self.more..range.end * self.more, others.beyond);
        self.shares.splice(range.clone(), others.shares);
        if self.compensates {
            self.offsets.splice(range.clone(), others.offsets);
        }
        self.list.splice(range, others.list);
    }

    /// Adds a span, how the cutter's centre lies off it, and where the axes beyond X, Y and Z are at its ends.
    pub(crate) fn push(&mut self, span: Span, offset: Offset, beyond: impl Iterator<Item = [f64; 2]>) {
        self.shares.push(Share::of(&span));
        self.list.push(span);
        self.beyond.extend(beyond);
        if self.compensates {
            self.offsets.push(offset);
        }
    }

    /// What each adds to the totals.
    pub(crate) fn shares(&self) -> &[Share] {
        &self.shares
    }

    /// How the cutter's centre lies off each span; empty where the format states no radius of a cutter.
    pub fn offsets(&self) -> &[Offset] {
        &self.offsets
    }

    /// Where the axes beyond X, Y and Z are at the start and at the end of each span, axis by axis.
    pub fn beyond(&self) -> &[[f64; 2]] {
        &self.beyond
    }

    /// Every axis at the start of a span.
    pub fn start(&self, index: usize) -> Vec<f64> {
        self.ends(index, 0)
    }

    /// Every axis at the end of a span.
    pub fn end(&self, index: usize) -> Vec<f64> {
        self.ends(index, 1)
    }

    fn ends(&self, index: usize, which: usize) -> Vec<f64> {
        let span = &self.list[index];
        let beyond = &self.beyond[index * self.more..(index + 1) * self.more];
        [span.start, span.end][which].into_iter().chain(beyond.iter().map(|ends| ends[which])).collect()
    }

    /// The spans that a block takes part in: none, or one, or two where it ends one and stands in for another.
    pub fn of_block(&self, block: usize) -> Range<usize> {
        let from = self.list.partition_point(|span| span.blocks.1 < block);
        let to = self.list.partition_point(|span| span.blocks.0 <= block);
        from..to.max(from)
    }
}

impl Span {
    /// X, Y and Z stand still: another axis moves alone, or none while the tool dwells. There is nothing to be drawn.
    pub(crate) fn is_still(&self) -> bool {
        self.geometry == Geometry::Line && self.start == self.end
    }

    /// The smallest box around the span: least and greatest X, Y and Z.
    pub fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        let mut least = std::array::from_fn(|axis| self.start[axis].min(self.end[axis]));
        let mut greatest = std::array::from_fn(|axis| self.start[axis].max(self.end[axis]));
        let mut take = |axis: usize, value: f64| {
            least[axis] = f64::min(least[axis], value);
            greatest[axis] = f64::max(greatest[axis], value);
        };
        match self.geometry {
            Geometry::Line => {}
            Geometry::Arc(arc) => arc.extremes().for_each(|(axis, value)| take(axis, value)),
            Geometry::Parabola { tangent } => {
                for (axis, tangent) in tangent.into_iter().enumerate() {
                    let (start, end) = (self.start[axis], self.end[axis]);
                    // P'(t) = 0 at t = (P0 - PT) / (P0 - 2 PT + P2), where that lies between the ends.
                    let t = (start - tangent) / (start - 2.0 * tangent + end);
                    if t > 0.0 && t < 1.0 {
                        let s = 1.0 - t;
                        take(axis, s * s * start + 2.0 * s * t * tangent + t * t * end);
                    }
                }
            }
            Geometry::Curve { control } => {
                let curve = Cubic { start: self.start, control, end: self.end };
                for axis in 0..3 {
                    curve.turns(axis).for_each(|t| take(axis, curve.point(t)[axis]));
                }
            }
        }
        (least, greatest)
    }
}

impl Arc {
    /// Where the arc crosses a direction of an axis: that axis, and the coordinate there. The larger radius is taken,
    /// so that the box holds the arc where its ends are off by a rounding.
    fn extremes(&self) -> impl Iterator<Item = (usize, f64)> {
        let [first, second, _] = self.plane.axes();
        let radius = self.start_radius.max(self.end_radius);
        let (from, to) = (self.start_angle, self.start_angle + self.sweep);
        let (low, high) = (from.min(to), from.max(to));
        // The start angle lies in one turn about zero and the sweep adds at most another: quarters -8 to 8 cover both.
        (-8..=8).filter_map(move |quarter: i32| {
            let angle = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
            (low < angle && angle < high).then(|| match quarter.rem_euclid(4) {
                0 => (first, self.centre[0] + radius),
                1 => (second, self.centre[1] + radius),
                2 => (first, self.centre[0] - radius),
                _ => (second, self.centre[1] - radius),
            })
        })
    }
}
