//! Tool positions (type 5000): from points to spans.

use super::circle::Course;
use super::element::Element;
use super::event::Event;
use super::execution::{Per, State};
use super::record::Record;
use super::step::{Act, Motion};
use crate::span::{Arc, Geometry, Offset, Span, SpanKind};

/// The farthest place that is computed with, in the unit of the report: a thousand million of them. Far beyond any
/// machine, and squares and sums of such lengths are far from the greatest number.
const FARTHEST: f64 = 1e9;

/// A tool position, and whether all of it could be read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub at: [f64; 3],
    pub record: usize,
    pub sound: bool,
    /// It is where the tool really goes, and its tool axis is known where it should have one.
    pub whole: bool,
    /// Its tool axis, where it has one.
    pub axis: Option<[f64; 3]>,
    /// Its first coordinate in the table of all elements.
    pub element: usize,
}

impl State<'_> {
    pub(super) fn position(&mut self, index: usize, record: &Record) {
        let elements = self.tables.of(record);
        match elements.get(2).and_then(Element::whole) {
            Some(3) => {
                let points = self.points(index, index, false);
                if let Some(last) = points.last() {
                    self.file.position = Some(last.at);
                    self.file.tool_axis = last.axis;
                    self.keep(index, |_| Act::From(last.at));
                }
            }
            Some(4) => {
                let is_unknown = self.file.position.is_none();
                if is_unknown {
                    self.note(Event::UnknownStart { needed: true }, index, None);
                    self.file.position = Some([0.0; 3]);
                }
                let mut points = self.points(index, index, true);
                points.iter_mut().for_each(|point| point.whole &= !is_unknown);
                self.travel(index, index, &points);
            }
            Some(5) => {
                let last = self.continued(index);
                self.file.continued = last;
                let points = self.points(index, last, false);
                self.travel(index, last, &points);
            }
            Some(6) if index > self.file.continued || index == 0 => {
                self.note(Event::StrayContinuation, index, None);
                let points = self.points(index, index, false);
                self.travel(index, index, &points);
            }
            _ => {}
        }
    }

    fn subtype(&self, index: usize) -> Option<i64> {
        let record = self.tables.records.get(index).filter(|record| record.kind == 5000)?;
        self.tables.of(record).get(2).and_then(Element::whole)
    }

    /// The last record by which a motion goes on. Identifications of statements may stand between.
    fn continued(&self, first: usize) -> usize {
        let file = self.tables.records[first].file;
        let mut last = first;
        for (index, record) in self.tables.records.iter().enumerate().skip(first + 1) {
            match self.subtype(index) {
                Some(6) if record.file == file => last = index,
                _ if record.kind == 1000 && record.file == file => {}
                _ => break,
            }
        }
        last
    }

    /// The points of a motion. A coordinate that cannot be read stays as it was.
    fn points(&mut self, first: usize, last: usize, differences: bool) -> Vec<Point> {
        let tables = self.tables;
        let mut points = Vec::new();
        let mut at = self.file.position.unwrap_or_default();
        for index in first..=last {
            let record = &tables.records[index];
            if record.kind != 5000 {
                continue;
            }
            let values = tables.of(record).get(5..).unwrap_or_default();
            let size = if differences { 3 } else { self.file.point_size };
            if values.len() % size != 0 && values.len() >= 3 {
                let event = Event::IncompletePoint { values: values.len(), size };
                self.note(event, index, Some(record.last as usize - 1));
            }
            for (place, point) in values.chunks(size).enumerate().filter(|(_, point)| point.len() >= 3) {
                let (mut next, mut sound) = (at, true);
                for (axis, element) in point.iter().take(3).enumerate() {
                    match element.value().map(|value| value * self.file.scale) {
                        Some(value) => next[axis] = if differences { at[axis] + value } else { value },
                        None => sound = false,
                    }
                    if next[axis].abs() > FARTHEST {
                        (next[axis], sound) = (at[axis], false);
                        let element = record.first as usize + 5 + place * size + axis;
                        self.note(Event::TooFar, index, Some(element));
                    }
                }
                at = next;
                let axis = match point {
                    [.., i, j, k] if point.len() == 6 => i.value().zip(j.value()).zip(k.value()),
                    _ => None,
                };
                let axis = axis.map(|((i, j), k)| [i, j, k]);
                let whole = sound && (axis.is_some() || size == 3);
                let element = record.first as usize + 5 + place * size;
                points.push(Point { at, record: index, sound, whole, axis, element });
            }
        }
        points
    }

    /// Moves through points, along the circle that waits for them where one does.
    fn travel(&mut self, first: usize, last: usize, points: &[Point]) {
        let Some(end) = points.last().copied() else { return };
        self.file.tool_axis = end.axis;
        if self.file.ended {
            self.note(Event::BehindEnd, first, None);
            self.file.ended = false;
        }
        if !std::mem::replace(&mut self.file.moved, true) && self.file.unit.is_none() {
            self.note(Event::AssumedUnit, first, None);
        }
        let rapid = self.file.rapid.take().is_some();
        let circle = self.file.circle.take();
        let start = self.file.position.replace(end.at);
        let Some(start) = start else {
            self.note(Event::UnknownStart { needed: circle.is_some() }, first, None);
            let mut from = points[0];
            // An arc needs its start.
            let first = Point { whole: from.whole && circle.is_none(), ..from };
            self.keep_motion(None, first, None, rapid, None);
            for point in &points[1..] {
                self.straight(from.at, *point, rapid);
                from = *point;
            }
            return;
        };
        if let Some(circle) = circle {
            match self.course(&circle, start, points, first) {
                Course::Arc(arc) if self.file.cut => {
                    let third = arc.plane.axes()[2];
                    let length = libm::hypot(arc.length_in_plane(), end.at[third] - start[third]);
                    self.keep_motion(Some(start), end, Some(arc), rapid, Some(circle.record));
                    let kind = if rapid || self.file.cycle { SpanKind::Rapid } else { SpanKind::Arc };
                    self.push(kind, (circle.record, last), Geometry::Arc(arc), start, end.at, length, !end.sound);
                    self.ends.push(end.element as u32);
                }
                Course::Arc(_) => {}
                Course::Chords { substitute } => {
                    let mut from = start;
                    for point in points {
                        self.straight(from, Point { sound: point.sound && !substitute, ..*point }, rapid);
                        from = point.at;
                    }
                }
            }
            return;
        }
        let mut from = start;
        for point in points {
            self.straight(from, *point, rapid);
            from = point.at;
        }
    }

    fn straight(&mut self, from: [f64; 3], to: Point, rapid: bool) {
        self.keep_motion(Some(from), to, None, rapid, None);
        // Under a cycle the tool goes to each hole above the part.
        let rapid = rapid || self.file.cycle;
        let [x, y, z] = std::array::from_fn(|axis| to.at[axis] - from[axis]);
        let length = (x * x + y * y + z * z).sqrt();
        // Between DNTCUT and CUT nothing is put out.
        if !self.file.cut || length == 0.0 {
            return;
        }
        let kind = if rapid { SpanKind::Rapid } else { SpanKind::Line };
        self.push(kind, (to.record, to.record), Geometry::Line, from, to.at, length, !to.sound);
        self.ends.push(to.element as u32);
    }

    /// Keeps a move, where steps are wanted.
    fn keep_motion(&mut self, from: Option<[f64; 3]>, to: Point, arc: Option<Arc>, rapid: bool, circle: Option<usize>) {
        if !self.file.cut {
            return;
        }
        self.keep(to.record, |state| {
            Act::Motion(Box::new(Motion {
                arc,
                from,
                to: to.at,
                axis: to.axis,
                rapid,
                sound: to.sound && to.whole,
                element: to.element,
                circle,
                feed: state.file.feed,
                per: state.file.per,
                speed: state.file.speed,
            }))
        });
    }

    #[expect(clippy::too_many_arguments, reason = "it is all that a span is")]
    fn push(
        &mut self,
        kind: SpanKind,
        blocks: (usize, usize),
        geometry: Geometry,
        start: [f64; 3],
        end: [f64; 3],
        length: f64,
        substitute: bool,
    ) {
        let feed = if kind == SpanKind::Rapid { None } else { self.feed_of(blocks.0) };
        let feed = feed.filter(|feed| feed.is_finite() && *feed > 0.0 && !substitute);
        let seconds = feed.map(|feed| length / feed * 60.0).filter(|seconds| seconds.is_finite());
        let span = Span { kind, blocks, geometry, start, end, length, angular: false, feed, seconds, substitute };
        self.spans.push(span, Offset::None, std::iter::empty());
    }

    /// The feed in the unit of the report per minute; what is lacking is noted.
    fn feed_of(&mut self, record: usize) -> Option<f64> {
        let count = |first: &mut Option<(usize, usize)>| {
            let (record, count) = first.unwrap_or((record, 0));
            *first = Some((record, count + 1));
        };
        if !self.file.turning {
            count(&mut self.file.spindle_off);
        }
        let Some(feed) = self.file.feed else {
            count(&mut self.file.without_feed);
            return None;
        };
        match self.file.per {
            Per::Minute => Some(feed),
            Per::Revolution => self.file.speed.map(|speed| feed * speed),
            Per::Other => None,
        }
    }
}
