//! Spans with their length, feed and time.

use super::cubic::Cubic;
use super::event::{Event, EventKind};
use super::feed::Feed;
use super::parabola::{Parabola, norm, subtract};
use super::state::{State, in_unit};
use crate::format::ArcFeed;
use crate::span::{Geometry, Offset, Span, SpanKind};

/// Below it the next number of a reciprocal of time is more than a quarter faster. At 4, which annex E has, it is just
/// that.
const COARSE: i64 = 4;

impl State<'_> {
    /// A straight stand-in from `start` to the target, whose feed and time are not known.
    pub(super) fn substitute(&mut self, start: &[i64], first: usize) {
        if *start == *self.target {
            return;
        }
        let (from, to) = (self.point(start), self.point(&self.target));
        let Some((length, angular)) = self.straight_length(start, from, to) else { return };
        let span = Span {
            kind: SpanKind::Line,
            blocks: (first, self.block),
            geometry: Geometry::Line,
            start: from,
            end: to,
            length,
            angular,
            feed: None,
            seconds: None,
            substitute: true,
        };
        self.push_span(span, start);
    }

    pub(super) fn push(
        &mut self,
        kind: SpanKind,
        blocks: (usize, usize),
        start: &[i64],
        geometry: Geometry,
        sweep: Option<f64>,
    ) {
        let (from, to) = (self.point(start), self.point(&self.target));
        let mut angular = false;
        let length = match geometry {
            Geometry::Line => {
                let Some(straight) = self.straight_length(start, from, to) else { return };
                angular = straight.1;
                straight.0
            }
            Geometry::Arc(arc) => {
                let third = arc.plane.axes()[2];
                libm::hypot(arc.length_in_plane(), to[third] - from[third])
            }
            Geometry::Parabola { tangent } => Parabola { start: from, tangent, end: to }.length(),
            Geometry::Curve { control } => Cubic { start: from, control, end: to }.length(),
        };
        if kind != SpanKind::Rapid && blocks.0 == blocks.1 && self.compensation.vector.is_some() {
            self.check_vector(&geometry, from, to);
        }
        if kind == SpanKind::Parabola && matches!(self.feed, Feed::Reciprocal(_)) {
            self.events.push(Event { block: blocks.0, kind: EventKind::ReciprocalParabola });
        }
        // The highest code of a feed is rapid traverse, as G00 is (annex A). A thread runs by its lead.
        let straight = kind == SpanKind::Line && !self.is_thread();
        let kind = if straight && self.feed == Feed::Rapid { SpanKind::Rapid } else { kind };
        let minutes = match kind {
            SpanKind::Rapid => self.rapid(length),
            _ if self.is_thread() => self.thread_minutes(start, length),
            _ => self.minutes(length, sweep),
        };
        let minutes = minutes.filter(|minutes| minutes.is_finite() && *minutes > 0.0);
        let feed = minutes.map(|minutes| length / minutes).filter(|feed| feed.is_finite());
        let seconds = minutes.map(|minutes| minutes * 60.0).filter(|seconds| seconds.is_finite());
        let span = Span {
            kind,
            blocks,
            geometry,
            start: from,
            end: to,
            length,
            angular,
            feed: self.plain_feed().filter(|_| kind != SpanKind::Rapid).or(feed),
            seconds,
            substitute: false,
        };
        // A feed per minute was judged at its word; a rapid move has none, and what moves a rotary axis alone has none
        // along the path.
        let by_span = self.is_thread() || matches!(self.feed, Feed::Reciprocal(_) | Feed::PerRevolution(_));
        if let Some(feed) = feed.filter(|_| by_span && kind != SpanKind::Rapid && !angular) {
            self.note_speed(None, feed);
            // A thread runs by its lead, and zero is the number of no time.
            if let (Feed::Reciprocal(_), Some((word, Some(number)))) = (self.feed, self.own_feed)
                && (1..COARSE).contains(&number)
                && !self.is_thread()
            {
                self.note(EventKind::CoarseReciprocal { word, feed, step: feed / number as f64 });
            }
        }
        self.push_span(span, start);
    }

    pub(super) fn push_span(&mut self, span: Span, start: &[i64]) {
        let control = self.control;
        let ends = start.iter().zip(self.target.iter()).zip(&control.axes).skip(3);
        let offset = if span.substitute { Offset::None } else { self.offset() };
        self.spans.push(span, offset, ends.map(|((&start, &end), axis)| [start, end].map(|at| in_unit(axis, at))));
    }

    /// The feed as the tape states it, where it states one along the path. A thread runs by its lead.
    fn plain_feed(&self) -> Option<f64> {
        let thread = self.is_thread();
        if let Feed::PerMinute(feed) = self.feed { Some(feed).filter(|feed| *feed > 0.0 && !thread) } else { None }
    }

    /// Minutes for a cutting span (annex A), noting what the F words lack.
    fn minutes(&mut self, length: f64, sweep: Option<f64>) -> Option<f64> {
        match self.feed {
            Feed::PerMinute(feed) if feed > 0.0 => Some(length / feed),
            Feed::PerRevolution(feed) if feed > 0.0 => {
                self.speed.filter(|speed| *speed > 0.0).map(|speed| length / (feed * speed))
            }
            Feed::Reciprocal(rate) if rate > 0.0 => {
                if self.own_feed.is_none() {
                    self.note(EventKind::NoOwnFeed);
                }
                let by_time = 1.0 / rate;
                let Some(sweep) = sweep else { return Some(by_time) };
                let by_radians = sweep.abs() / rate;
                if self.control.format.itemized.arc_feed.is_none() {
                    let (by_radians, by_time) = (length / by_radians, length / by_time);
                    self.note(EventKind::ArcFeedNotStated { by_radians, by_time });
                }
                Some(if self.control.arc_feed == ArcFeed::Time { by_time } else { by_radians })
            }
            Feed::Rapid => self.rapid(length),
            Feed::Unknown => None,
            Feed::PerMinute(_) | Feed::PerRevolution(_) if self.is_geometric() => {
                self.note(EventKind::StopFeed);
                None
            }
            _ => {
                self.note(EventKind::NoFeed);
                None
            }
        }
    }

    /// Minutes at rapid traverse.
    fn rapid(&self, length: f64) -> Option<f64> {
        self.control.format.itemized.rapid.map(|rapid| length / rapid.0)
    }

    /// The length of a straight move, and whether it is an angle: see [`Span::length`]. None where the ends are one
    /// point; beyond 2^53 increments two positions may be one in the unit of the format.
    fn straight_length(&self, start: &[i64], from: [f64; 3], to: [f64; 3]) -> Option<(f64, bool)> {
        let path = norm(subtract(to, from));
        if path > 0.0 {
            return Some((path, false));
        }
        let beyond = |rotary: bool| {
            let axes = (3..self.target.len()).filter(move |&axis| self.control.axes[axis].is_rotary() == rotary);
            let moves = axes.map(|axis| self.in_unit(axis, self.target[axis]) - self.in_unit(axis, start[axis]));
            Some((moves.fold(0.0, libm::hypot), rotary)).filter(|(length, _)| *length > 0.0)
        };
        beyond(false).or_else(|| beyond(true))
    }
}
