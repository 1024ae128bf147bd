//! The motion of one block: which kind of span its words make.

use super::event::{Event, EventKind};
use super::state::{Motion, State, bit};
use crate::format::Standard;
use crate::span::{Geometry, SpanKind};

impl State<'_> {
    /// Carries out the motion of the block whose words were taken.
    pub(crate) fn move_tool(&mut self) {
        if self.is_motionless() {
            self.stand();
            return;
        }
        self.take_vector();
        let parametric = self.parametric;
        if !self.addressed && !parametric {
            return;
        }
        let motion = self.motion.unwrap_or_else(|| {
            if self.addressed {
                self.note(EventKind::NoInterpolation { lost: self.lost_function });
            }
            // A positioning control positions; a contouring one is taken to interpolate, so that the path is seen.
            if self.control.standard() == Standard::Iso1058 { Motion::Rapid } else { Motion::Line }
        });
        self.count_axes(motion);
        self.check_travel();
        match motion {
            Motion::Rapid => self.straight(SpanKind::Rapid, 0),
            Motion::Line => self.straight(SpanKind::Line, 1),
            Motion::Thread { .. } => self.straight(SpanKind::Line, 33),
            Motion::Circle { clockwise } if parametric => self.arc(clockwise),
            Motion::Circle { clockwise } => self.arc_point(clockwise),
            Motion::Parabola if parametric => self.parabola(),
            Motion::Parabola => self.parabola_point(),
            Motion::Curve { code } => self.curve_point(code),
        }
        self.position = self.target;
    }

    /// Ends a span of several blocks that is not complete: its points are joined by a stand-in.
    pub(crate) fn finish_span(&mut self) {
        let Some(pending) = self.pending.take() else { return };
        if !pending.doubtful {
            self.events.push(Event { block: pending.block, kind: EventKind::Unfinished(pending.several) });
        }
        let target = std::mem::replace(&mut self.target, self.position);
        let block = self.block;
        self.block = pending.last;
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
        let axes = || (0..self.target.len()).filter(moves);
        if axes().count() > usize::from(allowed) {
            let positioning = motion == Motion::Rapid || self.control.standard() == Standard::Iso1058;
            let moving = axes().fold(0, |set, axis| set | bit(axis));
            self.note(EventKind::TooManyAxes { moving, allowed, positioning });
        }
    }

    /// Notes the words that take their axis beyond its travel. Where incremental words go on beyond it, only the one
    /// that left it is at fault.
    fn check_travel(&mut self) {
        let control = self.control;
        for (index, &travel) in control.travel.iter().enumerate() {
            let (Some(word), Some(travel)) = (self.words[index], travel) else { continue };
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
        if code == 33 {
            self.take_leads();
        } else {
            for parameter in self.parameters.into_iter().flatten() {
                self.note(EventKind::IdleParameter { word: parameter.place, code });
            }
        }
        if self.target == self.position {
            self.leave_out(self.is_doubtful([]));
            // A first block that states the set point moves nothing and is as it should be.
            if self.words.iter().any(Option::is_some) && self.moved() && !self.is_doubtful([]) {
                self.note(EventKind::NoMotion);
            }
            return;
        }
        let start = self.position;
        if code == 33 && !self.is_doubtful([]) {
            self.check_leads(&start);
        }
        // A word that could not be read may have been any: how far the tool moves is not known.
        if self.is_doubtful((0..self.words.len()).filter(|&axis| self.words[axis].is_some())) {
            self.substitute(&start, self.block);
        } else {
            self.push(kind, (self.block, self.block), &start, Geometry::Line, None);
        }
    }
}
