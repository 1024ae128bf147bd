//! Arcs as blocks say them: in one block by interpolation parameters, or in two by an intermediate point (4.2.2).

use super::circle::{ArcBlock, ArcFault, Lack, tolerance};
use super::event::{Event, EventKind, Several};
use super::state::{Pending, State};
use crate::format::{Angles, ArcCentre, ArcParameters, power_of_ten};
use crate::span::{Arc, Geometry, SpanKind};
use std::f64::consts::TAU;

impl State<'_> {
    /// An arc in one block: 4.2.2.1.
    pub(super) fn arc(&mut self, clockwise: bool) {
        self.finish_span();
        let start = self.position;
        let by_angle = self.control.arc_parameters == ArcParameters::AngleRadius;
        let [first, second, third] = self.plane.axes();
        let moved = self.words[third].filter(|_| self.target[third] != start[third] && !self.control.helix);
        let given = self.parameters[third].map(|parameter| parameter.place).filter(|_| !by_angle);
        // Said once, at the first of them; that the rest of the arc does not fit either follows from it.
        if let Some(word) = moved.or(given) {
            self.note(EventKind::OutOfPlane { word });
        }
        if moved.is_some() || self.is_doubtful([first, second]) {
            self.leave_out(self.target == start);
            self.substitute(&start, self.block);
            return;
        }
        let mut block = self.arc_block(clockwise, &start);
        // A centre or radius is rounded to its own increment, which may be coarser than that of the axes.
        let lengths = if by_angle { &[1][..] } else { &[first, second] };
        for &parameter in lengths.iter().filter(|&&index| self.parameters[index].is_some()) {
            block.tolerance = block.tolerance.max(tolerance(self.parameter_step(parameter)));
        }
        if by_angle {
            let solved = self.arc_by_angle(&block);
            self.note_idle(2, if clockwise { 2 } else { 3 });
            match solved {
                Ok(arc) => self.push_arc(arc, &start),
                Err(fault) => {
                    self.note(EventKind::Arc(fault));
                    self.substitute(&start, self.block);
                }
            }
            return;
        }
        let full_circle = self.control.format.itemized.full_circle;
        if block.start == block.end && full_circle == Some(false) {
            if self.target == start {
                self.note(EventKind::NoMotion);
            }
            self.substitute(&start, self.block);
            return;
        }
        match self.solve(&block, [first, second]) {
            Ok(arc) => {
                if block.start == block.end && full_circle.is_none() {
                    self.note(EventKind::FullCircle);
                }
                self.push_arc(arc, &start);
            }
            Err(fault) => {
                if given.is_none() {
                    self.note(EventKind::Arc(fault));
                }
                self.substitute(&start, self.block);
            }
        }
    }

    fn push_arc(&mut self, arc: Arc, start: &[i64]) {
        self.push(SpanKind::Arc, (self.block, self.block), start, Geometry::Arc(arc), Some(arc.sweep));
    }

    /// The arc whose included angle is I, in the angular unit of the classification, and whose radius is J (figure 2).
    fn arc_by_angle(&self, block: &ArcBlock) -> Result<Arc, ArcFault> {
        let lacks = |lack| Err(ArcFault::NotDetermined(lack));
        let full_turn = match self.control.angles() {
            Angles::Turns => 1.0,
            Angles::Degrees => 360.0,
        };
        let Some(turns) = self.parameter(0).map(|angle| angle / full_turn) else { return lacks(Lack::Angle) };
        let Some(radius) = self.parameter(1) else { return lacks(Lack::Radius) };
        match radius {
            _ if block.start == block.end => lacks(Lack::Closed),
            _ if turns <= 0.0 || turns >= 1.0 => lacks(Lack::AngleRange),
            0.0 => Err(ArcFault::ZeroRadius),
            ..0.0 => lacks(Lack::NegativeRadius),
            _ => block.by_angle(turns * TAU, self.parameter_step(0) / full_turn * TAU, radius),
        }
    }

    /// The number of a parameter as it stands on the tape.
    pub(super) fn parameter(&self, index: usize) -> Option<f64> {
        let places = self.control.designation(b"IJK"[index]).map_or(0, |word| word.after);
        self.parameters[index].map(|parameter| parameter.value as f64 / power_of_ten(places) as f64)
    }

    /// The increment of a parameter.
    pub(super) fn parameter_step(&self, index: usize) -> f64 {
        let places = self.control.designation(b"IJK"[index]).map_or(0, |word| word.after);
        1.0 / power_of_ten(places) as f64
    }

    /// Notes a parameter that the function has no use for.
    pub(super) fn note_idle(&mut self, index: usize, code: u8) {
        if let Some(parameter) = self.parameters[index] {
            self.note(EventKind::IdleParameter { word: parameter.place, code });
        }
    }

    pub(super) fn arc_block(&self, clockwise: bool, start: &[i64]) -> ArcBlock {
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
        let stated = self.control.arc_centre;
        let result = self.arc_by(stated, block, axes);
        let Err(ArcFault::RadiusMismatch { start, end, tolerance, .. }) = result else { return result };
        let others = [ArcCentre::ToStart, ArcCentre::FromStart, ArcCentre::Absolute];
        let fits = others.into_iter().find(|&other| {
            let differs = axes.iter().any(|&axis| self.reading_under(stated, axis) != other);
            differs && self.arc_by(other, block, axes).is_ok()
        });
        let read = self.reading_under(stated, axes[0]);
        Err(ArcFault::RadiusMismatch { start, end, tolerance, read, fits })
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

    pub(super) fn reading(&self, axis: usize) -> ArcCentre {
        self.reading_under(self.control.arc_centre, axis)
    }

    /// The coordinate that the parameter of an axis gives under a reading. It is added up in whole increments, so
    /// that a centre is as exact as the tape says it. A parameter that is left out says no change: the coordinate of
    /// the start.
    pub(super) fn coordinate(&self, axis: usize, reading: ArcCentre) -> f64 {
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
    pub(super) fn arc_point(&mut self, clockwise: bool) {
        if self.centre_in_vector {
            let start = self.position;
            self.substitute(&start, self.block);
            return;
        }
        let Some(pending) = self.pending.take() else {
            let [first, second, _] = self.plane.axes();
            let doubtful = self.is_doubtful([first, second]);
            let (block, start, several) = (self.block, self.position, Several::Arc);
            self.pending = Some(Pending { block, last: block, start, middle: None, several, doubtful });
            return;
        };
        let start = pending.start;
        let blocks = (pending.block, self.block);
        let [first, second, third] = self.plane.axes();
        let leaves = |position: &[i64]| position[third] != start[third];
        let doubtful = pending.doubtful || self.is_doubtful([first, second]);
        let out_of_plane = !self.control.helix && (leaves(&self.position) || leaves(&self.target));
        if out_of_plane || doubtful {
            if !doubtful {
                self.events.push(Event { block: pending.block, kind: EventKind::ThirdAxisMoves });
            }
            self.leave_out(self.target == start);
            self.substitute(&start, pending.block);
            return;
        }
        let middle = [self.in_unit(first, self.position[first]), self.in_unit(second, self.position[second])];
        match self.arc_block(clockwise, &start).through(middle) {
            Some(arc) => {
                if (arc.sweep < 0.0) != clockwise {
                    self.events.push(Event { block: pending.block, kind: EventKind::OtherWay { clockwise } });
                }
                self.push(SpanKind::Arc, blocks, &start, Geometry::Arc(arc), Some(arc.sweep));
            }
            None => {
                self.events.push(Event { block: pending.block, kind: EventKind::OnALine });
                self.substitute(&start, pending.block);
            }
        }
    }
}
