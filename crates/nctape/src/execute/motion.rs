//! From the words of one block, and the points that wait, to spans.

use super::circle::{ArcBlock, ArcFault, tolerance};
use super::event::{Event, EventKind, Limit};
use super::feed::Feed;
use super::parabola::{Parabola, norm, subtract};
use super::state::{Motion, Pending, State};
use crate::format::{ArcCentre, ArcFeed, ArcParameters, ParabolaParameters, Standard, power_of_ten};
use crate::span::{Arc, Geometry, Span, SpanKind};

impl State<'_> {
    /// Carries out the motion of the block whose words were taken.
    pub(crate) fn move_tool(&mut self) {
        if self.is_motionless() {
            return;
        }
        let addressed = self.words.iter().any(Option::is_some);
        let parametric = self.parameters.iter().any(Option::is_some);
        if !addressed && !parametric {
            return;
        }
        let motion = self.motion.unwrap_or_else(|| {
            self.note(EventKind::NoInterpolation);
            // A positioning control positions; a contouring one is taken to interpolate, so that the path is seen.
            if self.control.standard() == Standard::Iso1058 { Motion::Rapid } else { Motion::Line { thread: false } }
        });
        self.count_axes(motion);
        self.check_travel();
        match motion {
            Motion::Rapid => self.straight(SpanKind::Rapid, 0),
            Motion::Line { thread } => self.straight(SpanKind::Line, if thread { 33 } else { 1 }),
            Motion::Circle { clockwise } if parametric => self.arc(clockwise),
            Motion::Circle { clockwise } => self.arc_point(clockwise),
            Motion::Parabola if parametric => self.parabola(),
            Motion::Parabola => self.parabola_point(),
        }
        self.position.clone_from(&self.target);
    }

    /// Ends a span of several blocks that is not complete: its points are joined by a stand-in.
    pub(crate) fn finish_span(&mut self) {
        let Some(pending) = self.pending.take() else { return };
        let kind = EventKind::Unfinished { parabola: pending.parabola };
        self.events.push(Event { block: pending.block, kind });
        let target = std::mem::replace(&mut self.target, self.position.clone());
        let block = self.block;
        self.block = pending.block;
        self.substitute(&pending.start, pending.block);
        self.block = block;
        self.target = target;
    }

    /// Notes where more axes move than the control moves at once (C.2.3).
    fn count_axes(&mut self, motion: Motion) {
        let Some(allowed) = self.control.simultaneous() else { return };
        // ISO 1058 does not contour at all: FUN-08 says so.
        let contours = matches!(motion, Motion::Circle { .. } | Motion::Parabola);
        if contours && self.control.standard() == Standard::Iso1058 {
            return;
        }
        // An arc that leaves its plane is a fault of its own.
        let out_of_plane = match motion {
            Motion::Circle { .. } if !self.control.helix => Some(self.plane.axes()[2]),
            _ => None,
        };
        let moves = |axis: &usize| self.target[*axis] != self.position[*axis] && Some(*axis) != out_of_plane;
        let axes = (0..self.target.len()).filter(moves);
        let moving: String = axes.map(|axis| self.control.axes[axis].letter).collect();
        if moving.chars().count() > usize::from(allowed) {
            let positioning = motion == Motion::Rapid || self.control.standard() == Standard::Iso1058;
            self.note(EventKind::TooManyAxes { moving, allowed, positioning });
        }
    }

    /// Notes the words that take their axis beyond its travel. Where incremental words go on beyond it, only the one
    /// that left it is at fault.
    fn check_travel(&mut self) {
        let control = self.control;
        let Some(travels) = &control.format.itemized.travel else { return };
        for (index, axis) in control.axes.iter().enumerate() {
            let (Some(word), Some(&travel)) = (self.words[index], travels.get(&axis.letter.to_string())) else {
                continue;
            };
            let beyond = |increments: i64| {
                let at = self.in_unit(index, increments);
                (at < travel.0 || at > travel.1).then_some(at)
            };
            let known = self.is_incremental(index) && beyond(self.position[index]).is_some();
            let doubtful = self.is_incremental(index) && self.is_lost(index);
            if let Some(at) = beyond(self.target[index]).filter(|_| !known && !doubtful) {
                self.note(EventKind::OutOfTravel { word, at, travel });
            }
        }
    }

    fn straight(&mut self, kind: SpanKind, code: u8) {
        if code != 33 {
            for parameter in self.parameters.into_iter().flatten() {
                self.note(EventKind::IdleParameter { word: parameter.place, code });
            }
        }
        if self.target == self.position {
            // A first block that states the set point moves nothing and is as it should be.
            if self.words.iter().any(Option::is_some) && !self.spans.list.is_empty() && !self.is_doubtful([]) {
                self.note(EventKind::NoMotion);
            }
            return;
        }
        let start = self.position.clone();
        self.push(kind, (self.block, self.block), &start, Geometry::Line, None);
    }

    /// An arc in one block: 4.2.2.1.
    fn arc(&mut self, clockwise: bool) {
        self.finish_span();
        let start = self.position.clone();
        if self.control.arc_parameters != ArcParameters::Centre {
            self.refuse("arcParameters: angle-radius", &start);
            return;
        }
        let [first, second, third] = self.plane.axes();
        let moved = self.words[third].filter(|_| self.target[third] != start[third] && !self.control.helix);
        let given = self.parameters[third].map(|parameter| parameter.place);
        // Said once, at the first of them; that the rest of the arc does not fit either follows from it.
        if let Some(word) = moved.or(given) {
            self.note(EventKind::OutOfPlane { word });
        }
        let block = self.arc_block(clockwise, &start);
        if block.start == block.end && self.control.format.itemized.full_circle == Some(false) {
            self.note(EventKind::NoMotion);
            return;
        }
        match self.solve(&block, [first, second]) {
            Ok(arc) if moved.is_none() => {
                if block.start == block.end
                    && self.control.format.itemized.full_circle.is_none()
                    && !self.is_doubtful([first, second])
                {
                    self.note(EventKind::FullCircle);
                }
                self.push(SpanKind::Arc, (self.block, self.block), &start, Geometry::Arc(arc), Some(arc.sweep));
            }
            Ok(_) => self.substitute(&start, self.block),
            Err(fault) => {
                if moved.or(given).is_none() && !self.is_doubtful([first, second]) {
                    self.note(EventKind::Arc(fault));
                }
                self.substitute(&start, self.block);
            }
        }
    }

    fn arc_block(&self, clockwise: bool, start: &[i64]) -> ArcBlock {
        let [first, second, _] = self.plane.axes();
        let point = |position: &[i64]| [self.in_unit(first, position[first]), self.in_unit(second, position[second])];
        let increment = self.increment(first).max(self.increment(second));
        ArcBlock {
            plane: self.plane,
            start: point(start),
            end: point(&self.target),
            clockwise,
            tolerance: tolerance(increment),
        }
    }

    /// The arc by the reading of I, J and K that the format states. Where the end is off that circle, the reading
    /// under which it is not is named.
    fn solve(&self, block: &ArcBlock, axes: [usize; 2]) -> Result<Arc, ArcFault> {
        if axes.iter().all(|&axis| self.parameters[axis].is_none_or(|parameter| parameter.value == 0))
            && self.reading(axes[0]) != ArcCentre::Absolute
        {
            return Err(ArcFault::ZeroRadius);
        }
        let stated = self.control.arc_centre;
        let result = self.arc_by(stated, block, axes);
        let Err(ArcFault::RadiusMismatch { start, end, tolerance, .. }) = result else { return result };
        let others = [ArcCentre::ToStart, ArcCentre::FromStart, ArcCentre::Absolute];
        let fits = others.into_iter().find(|&other| {
            let differs = axes.iter().any(|&axis| self.reading_under(stated, axis) != other);
            differs && self.arc_by(other, block, axes).is_ok()
        });
        Err(ArcFault::RadiusMismatch { start, end, tolerance, fits })
    }

    fn arc_by(&self, reading: ArcCentre, block: &ArcBlock, axes: [usize; 2]) -> Result<Arc, ArcFault> {
        if reading == ArcCentre::Quadrant {
            return self.arc_in_quadrant(block, axes);
        }
        block.about(axes.map(|axis| self.coordinate(axis, self.reading_under(reading, axis))))
    }

    /// Unsigned parameters: of the four centres, the one whose arc ends on its circle within a quarter turn.
    fn arc_in_quadrant(&self, block: &ArcBlock, axes: [usize; 2]) -> Result<Arc, ArcFault> {
        let sides = [ArcCentre::FromStart, ArcCentre::ToStart];
        let (mut fault, mut leaves) = (None, false);
        for first in sides {
            for second in sides {
                let centre = [self.coordinate(axes[0], first), self.coordinate(axes[1], second)];
                match block.about(centre) {
                    Ok(arc) if block.is_in_quadrant(&arc) => return Ok(arc),
                    Ok(_) => leaves = true,
                    Err(other) => fault = fault.or(Some(other)),
                }
            }
        }
        Err(fault.filter(|_| !leaves).unwrap_or(ArcFault::LeavesQuadrant))
    }

    /// How the parameter of an axis is read: `as-dimensions` resolved.
    fn reading_under(&self, reading: ArcCentre, axis: usize) -> ArcCentre {
        match reading {
            ArcCentre::AsDimensions if self.is_incremental(axis) => ArcCentre::FromStart,
            ArcCentre::AsDimensions => ArcCentre::Absolute,
            other => other,
        }
    }

    fn reading(&self, axis: usize) -> ArcCentre {
        self.reading_under(self.control.arc_centre, axis)
    }

    /// The coordinate that the parameter of an axis gives under a reading. It is added up in whole increments, so
    /// that a centre is as exact as the tape says it. A parameter that is left out says no change: the coordinate of
    /// the start.
    fn coordinate(&self, axis: usize, reading: ArcCentre) -> f64 {
        let start = self.position[axis];
        let Some(parameter) = self.parameters[axis] else { return self.in_unit(axis, start) };
        let places = self.control.designation(b"IJK"[axis]).map_or(0, |word| word.after);
        let own = self.control.axes[axis].decimals;
        let most = places.max(own);
        let scaled = |value: i64, from: u8| value.checked_mul(power_of_ten(most - from));
        let exact = scaled(start, own).zip(scaled(parameter.value, places)).and_then(|(start, value)| match reading {
            ArcCentre::Absolute => Some(value),
            ArcCentre::ToStart => start.checked_sub(value),
            _ => start.checked_add(value),
        });
        let value = parameter.value as f64 / power_of_ten(places) as f64;
        match (exact, reading) {
            (Some(sum), _) => sum as f64 / power_of_ten(most) as f64,
            (None, ArcCentre::Absolute) => value,
            (None, ArcCentre::ToStart) => self.in_unit(axis, start) - value,
            (None, _) => self.in_unit(axis, start) + value,
        }
    }

    /// A point of an arc in two blocks: 4.2.2.2.
    fn arc_point(&mut self, clockwise: bool) {
        let Some(pending) = self.pending.take() else {
            let [first, second, _] = self.plane.axes();
            let doubtful = self.is_doubtful([first, second]);
            self.pending = Some(Pending { block: self.block, start: self.position.clone(), parabola: false, doubtful });
            return;
        };
        let start = pending.start;
        let blocks = (pending.block, self.block);
        let [first, second, third] = self.plane.axes();
        let leaves = |position: &[i64]| position[third] != start[third];
        if leaves(&self.position) || leaves(&self.target) {
            self.events.push(Event { block: pending.block, kind: EventKind::OutOfPlane { word: usize::MAX } });
            self.substitute(&start, pending.block);
            return;
        }
        let doubtful = pending.doubtful || self.is_doubtful([first, second]);
        let middle = [self.in_unit(first, self.position[first]), self.in_unit(second, self.position[second])];
        match self.arc_block(clockwise, &start).through(middle) {
            Some(arc) => {
                if (arc.sweep < 0.0) != clockwise && !doubtful {
                    self.events.push(Event { block: pending.block, kind: EventKind::OtherWay { clockwise } });
                }
                self.push(SpanKind::Arc, blocks, &start, Geometry::Arc(arc), Some(arc.sweep));
            }
            None => {
                if !doubtful {
                    self.events.push(Event { block: pending.block, kind: EventKind::OnALine });
                }
                self.substitute(&start, pending.block);
            }
        }
    }

    /// A parabola in one block: 4.2.3.1.
    fn parabola(&mut self) {
        self.finish_span();
        let start = self.position.clone();
        if self.control.parabola_parameters != ParabolaParameters::Tangent {
            let what = match self.control.parabola_parameters {
                ParabolaParameters::Focus => "parabolaParameters: focus",
                _ => "parabolaParameters: slope",
            };
            self.refuse(what, &start);
            return;
        }
        let tangent = std::array::from_fn(|axis| {
            let reading = match self.reading(axis) {
                // Without a sign there is no quadrant of a parabola to choose: the plain difference.
                ArcCentre::Quadrant => ArcCentre::FromStart,
                other => other,
            };
            self.coordinate(axis, reading)
        });
        let curve = Parabola { start: self.point(&start), tangent, end: self.point(&self.target) };
        let doubtful = self.is_doubtful(0..self.target.len());
        self.push_parabola(curve, &start, (self.block, self.block), false, doubtful);
    }

    /// A point of a parabola in two blocks: 4.2.3.2.
    fn parabola_point(&mut self) {
        let Some(pending) = self.pending.take() else {
            let doubtful = self.is_doubtful(0..self.target.len());
            self.pending = Some(Pending { block: self.block, start: self.position.clone(), parabola: true, doubtful });
            return;
        };
        let start = pending.start;
        let curve = Parabola::through(self.point(&start), self.point(&self.position), self.point(&self.target));
        let doubtful = pending.doubtful || self.is_doubtful(0..self.target.len());
        self.push_parabola(curve, &start, (pending.block, self.block), true, doubtful);
    }

    fn push_parabola(
        &mut self,
        curve: Parabola,
        start: &[i64],
        blocks: (usize, usize),
        intermediate: bool,
        doubtful: bool,
    ) {
        let increment = (0..3).filter(|&axis| self.control.axes[axis].sign.is_some());
        let increment = increment.map(|axis| self.increment(axis)).fold(0.0, f64::max);
        let degenerate = curve.is_degenerate(increment);
        let kind = match degenerate {
            true => Some(EventKind::Degenerate { intermediate }),
            false => (intermediate && curve.is_skewed()).then_some(EventKind::Skewed),
        };
        if let Some(kind) = kind.filter(|_| !doubtful) {
            self.events.push(Event { block: blocks.0, kind });
        }
        if degenerate {
            self.substitute(start, blocks.0);
            return;
        }
        let geometry = Geometry::Parabola { tangent: curve.tangent };
        self.push(SpanKind::Parabola, blocks, start, geometry, None);
    }

    fn refuse(&mut self, what: &'static str, start: &[i64]) {
        self.note(EventKind::NotCarriedOut(Limit::Parameters(what)));
        self.substitute(start, self.block);
    }

    /// A straight stand-in from `start` to the target, whose feed and time are not known.
    fn substitute(&mut self, start: &[i64], first: usize) {
        if start == self.target {
            return;
        }
        let (from, to) = (self.point(start), self.point(&self.target));
        let span = Span {
            kind: SpanKind::Line,
            blocks: (first, self.block),
            geometry: Geometry::Line,
            start: from,
            end: to,
            length: self.straight_length(start),
            feed: None,
            seconds: None,
            substitute: true,
        };
        self.push_span(span, start);
    }

    fn push(&mut self, kind: SpanKind, blocks: (usize, usize), start: &[i64], geometry: Geometry, sweep: Option<f64>) {
        let (from, to) = (self.point(start), self.point(&self.target));
        let length = match geometry {
            Geometry::Line => self.straight_length(start),
            Geometry::Arc(arc) => {
                let third = arc.plane.axes()[2];
                libm::hypot(arc.length_in_plane(), to[third] - from[third])
            }
            Geometry::Parabola { tangent } => Parabola { start: from, tangent, end: to }.length(),
        };
        if kind == SpanKind::Parabola && matches!(self.feed, Feed::Reciprocal(_)) {
            self.events.push(Event { block: blocks.0, kind: EventKind::ReciprocalParabola });
        }
        let minutes = if kind == SpanKind::Rapid {
            self.control.format.itemized.rapid.map(|rapid| length / rapid.0)
        } else {
            self.minutes(length, sweep)
        };
        let minutes = minutes.filter(|minutes| minutes.is_finite() && *minutes > 0.0);
        let feed = minutes.map(|minutes| length / minutes).filter(|feed| feed.is_finite());
        let seconds = minutes.map(|minutes| minutes * 60.0).filter(|seconds| seconds.is_finite());
        // A feed per minute was judged at its word; a rapid move has none.
        if let (Some(feed), Feed::Reciprocal(_) | Feed::PerRevolution(_)) = (feed.filter(|_| from != to), self.feed)
            && kind != SpanKind::Rapid
        {
            self.note_speed(None, feed);
        }
        let span = Span {
            kind,
            blocks,
            geometry,
            start: from,
            end: to,
            length,
            feed: self.plain_feed().filter(|_| kind != SpanKind::Rapid).or(feed),
            seconds,
            substitute: false,
        };
        self.push_span(span, start);
    }

    fn push_span(&mut self, span: Span, start: &[i64]) {
        let control = self.control;
        let unit = |position: &[i64]| -> Vec<f64> {
            let axes = position.iter().zip(&control.axes);
            axes.map(|(increments, axis)| *increments as f64 / power_of_ten(axis.decimals) as f64).collect()
        };
        self.spans.push(span, unit(start).into_iter(), unit(&self.target).into_iter());
    }

    /// The feed as the tape states it, where it states one along the path.
    fn plain_feed(&self) -> Option<f64> {
        if let Feed::PerMinute(feed) = self.feed { Some(feed).filter(|feed| *feed > 0.0) } else { None }
    }

    /// Minutes for a cutting span (annex A), noting what the F words lack.
    fn minutes(&mut self, length: f64, sweep: Option<f64>) -> Option<f64> {
        match self.feed {
            Feed::PerMinute(feed) if feed > 0.0 => Some(length / feed),
            Feed::PerRevolution(feed) if feed > 0.0 => {
                self.speed.filter(|speed| *speed > 0.0).map(|speed| length / (feed * speed))
            }
            Feed::Reciprocal(rate) if rate > 0.0 => {
                if !self.own_feed {
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
            Feed::Unknown => None,
            // The feed of a thread is its lead, I, J or K.
            _ if self.motion == Some(Motion::Line { thread: true }) => None,
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

    /// The length of a straight move: along X, Y and Z, or along the other axes where those stand still.
    fn straight_length(&self, start: &[i64]) -> f64 {
        let move_of = |axis: usize| self.in_unit(axis, self.target[axis]) - self.in_unit(axis, start[axis]);
        let path = norm(subtract(self.point(&self.target), self.point(start)));
        if path > 0.0 {
            return path;
        }
        (3..self.target.len()).map(move_of).fold(0.0, libm::hypot)
    }
}
