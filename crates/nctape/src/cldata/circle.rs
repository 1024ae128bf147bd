//! Arcs: the circle of a surface record (type 3000) and the tool positions behind it.
//!
//! Two customs are about. Systems of today write the circle of the path and its end alone, and the axis says the way
//! round by the right-hand rule. APT writes the circle of the part, so that the path is half a cutter beside it, and
//! points along the path, which say the way round; its axis is always the surface's.

use super::element::Element;
use super::event::Event;
use super::execution::{Circle, State};
use super::motion::Point;
use super::record::Record;
use crate::format::{Plane, Unit};
use crate::span::Arc;
use std::f64::consts::TAU;

/// How a motion along a circle goes.
pub(super) enum Course {
    Arc(Arc),
    /// From point to point; whether that is not the path.
    Chords {
        substitute: bool,
    },
}

/// How far an end may be off the circle, in millimetres: of 439 arcs of a system of today none is off by 0,001, and five
/// times that is still below what a machine can do.
const SLACK: f64 = 0.005;

/// An axis this near to a principal one is that: a thousandth of a millimetre over a metre.
const PARALLEL: f64 = 1e-6;

/// Beyond it a lone end point leaves the way round in doubt: of the same 439 arcs the longest has 180,2 degrees.
const HALF_TURN: f64 = 181.0;

impl State<'_> {
    /// 3000,2 of a circle or a cylinder: the next motion goes along it. Any other surface ends that.
    pub(super) fn surface(&mut self, index: usize, record: &Record) {
        let elements = self.tables.of(record);
        let whole = |place: usize| elements.get(place).and_then(Element::whole);
        if whole(2) != Some(2) {
            return;
        }
        if let Some(idle) = self.file.circle.take() {
            self.note(Event::IdleSurface, idle.record, None);
        }
        let mut reals = [0.0; 7];
        for (place, real) in reals.iter_mut().enumerate() {
            match elements.get(8 + place).and_then(Element::value) {
                Some(value) => *real = value,
                None => return,
            }
        }
        if !matches!(whole(4), Some(4 | 5)) {
            return;
        }
        let [x, y, z, i, j, k, radius] = reals;
        let length = (i * i + j * j + k * k).sqrt();
        let centre = [x, y, z].map(|value| value * self.file.scale);
        let radius = radius.abs() * self.file.scale;
        let is_near = centre.iter().all(|value| value.abs() < 1e9) && radius < 1e9;
        if length > 0.0 && length < 1e9 && is_near {
            let axis = [i, j, k].map(|value| value / length);
            self.file.circle = Some(Circle { record: index, centre, axis, radius });
        }
    }

    /// The way along a circle from where the tool stands through points.
    pub(super) fn course(&mut self, circle: &Circle, start: [f64; 3], points: &[Point], record: usize) -> Course {
        let lone = points.len() == 1;
        let principal = (0..3).find(|axis| circle.axis[*axis].abs() > 1.0 - PARALLEL);
        let Some(third) = principal else {
            self.note(Event::TiltedCircle, circle.record, None);
            return Course::Chords { substitute: lone };
        };
        let plane = [Plane::Yz, Plane::Zx, Plane::Xy][third];
        let [first, second, _] = plane.axes();
        let centre = [circle.centre[first], circle.centre[second]];
        let from_centre = |point: [f64; 3]| [point[first] - centre[0], point[second] - centre[1]];
        let distance = |vector: [f64; 2]| libm::hypot(vector[0], vector[1]);
        let end = points[points.len() - 1].at;
        let (from, to) = (from_centre(start), from_centre(end));
        let radii = [distance(from), distance(to)];
        let slack = (if self.unit == Unit::Inch { SLACK / 25.4 } else { SLACK }).max(self.file.tolerance);
        let half = self.file.cutter.unwrap_or(0.0).abs() / 2.0;
        let is_on = |radius: f64| radii.iter().all(|found| (found - radius).abs() <= slack);
        let fits = [circle.radius, circle.radius + half, (circle.radius - half).abs()].into_iter().any(is_on);
        if !fits || radii.contains(&0.0) {
            let [start, end] = radii;
            let event = Event::OffTheCircle { start, end, radius: circle.radius, cutter: self.file.cutter };
            self.note(event, record, None);
            return Course::Chords { substitute: lone };
        }
        let sweep = if lone {
            let sweep = around(from, to, circle.axis[third] > 0.0);
            let degrees = sweep.abs().to_degrees();
            if degrees > HALF_TURN && start != end {
                self.note(Event::DoubtfulDirection { degrees }, record, None);
            }
            sweep
        } else {
            let mut sum = 0.0;
            let mut before = from;
            for point in points {
                let next = from_centre(point.at);
                sum += turn(before, next);
                before = next;
            }
            sum
        };
        if sweep == 0.0 || !sweep.is_finite() || sweep.abs() > 2.0 * TAU {
            return Course::Chords { substitute: lone };
        }
        let start_angle = libm::atan2(from[1], from[0]);
        Course::Arc(Arc { plane, centre, start_radius: radii[0], end_radius: radii[1], start_angle, sweep })
    }
}

/// The angle from one direction to another, between minus and plus half a turn.
fn turn(from: [f64; 2], to: [f64; 2]) -> f64 {
    libm::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1])
}

/// The angle from one direction to another in a sense; all the way round where they are the same.
fn around(from: [f64; 2], to: [f64; 2], counter_clockwise: bool) -> f64 {
    let turn = turn(from, to);
    match counter_clockwise {
        true if turn <= 0.0 => turn + TAU,
        false if turn >= 0.0 => turn - TAU,
        _ => turn,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_ways_round() {
        let (east, north) = ([1.0, 0.0], [0.0, 2.0]);
        for (to, counter_clockwise, angle) in
            [(north, true, PI / 2.0), (north, false, -1.5 * PI), (east, true, TAU), (east, false, -TAU)]
        {
            assert!((around(east, to, counter_clockwise) - angle).abs() < 1e-15);
        }
    }
}
