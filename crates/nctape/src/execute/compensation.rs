//! Cutter compensation: what is in force, and what the words P, Q and R say (clause 5).
//!
//! P, Q and R are the components of a unit vector "at the beginning of each span". Words that are left out say no
//! change (3.2.3); yet a block that gives a unit vector by some of them alone means the others to be zero. Of the two
//! readings the one that has the length 1 is taken; both cannot have it but where they agree.

use super::event::EventKind;
use super::parabola::norm;
use super::state::{Motion, Parameter, State};
use crate::format::{ArcCentre, CompensationVector, power_of_ten};
use crate::span::{Geometry, Offset};

/// What G40 to G42 say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// Nothing yet: vectors are in force, a side is not.
    Unsaid,
    /// G40.
    Cancelled,
    /// G41.
    Left,
    /// G42.
    Right,
}

/// What passes from block to block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Compensation {
    pub side: Side,
    /// P, Q and R in force, each in its least increments; `None` where they are not known or no unit vector.
    pub vector: Option<[i64; 3]>,
}

impl Compensation {
    pub(crate) const NONE: Compensation = Compensation { side: Side::Unsaid, vector: None };
}

/// What the words P, Q and R of a block give.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Components {
    pub given: [Option<Parameter>; 3],
    /// One could not be read.
    pub unread: bool,
}

impl Components {
    fn any(&self) -> bool {
        self.given.iter().any(Option::is_some)
    }

    /// The components, with those that are left out from another vector.
    fn over(&self, others: [i64; 3]) -> [i64; 3] {
        std::array::from_fn(|axis| self.given[axis].map_or(others[axis], |given| given.value))
    }
}

impl State<'_> {
    /// Takes P, Q and R of the block, before its motion.
    pub(super) fn take_vector(&mut self) {
        if !self.components.any() && !self.components.unread {
            return;
        }
        let (components, vectors) = (self.components, self.control.vectors);
        if let Some(own_reading) = self.centre_in_vector() {
            self.note(EventKind::CentreInVector { own_reading });
            self.centre_in_vector = true;
            return;
        }
        if !vectors {
            let in_force = matches!(self.compensation.side, Side::Left | Side::Right);
            // One component of length 1 may as well be a move of that axis by 1.
            let several = components.given.iter().flatten().filter(|given| given.value != 0).count() > 1;
            if in_force && several && self.is_unit(components.over([0; 3])) {
                self.note(EventKind::VectorAsAxes);
            }
            return;
        }
        self.compensation.vector = if components.unread {
            None
        } else {
            let own = components.over([0; 3]);
            let merged = self.compensation.vector.map(|before| components.over(before));
            let fits = [Some(own), merged].into_iter().flatten().find(|vector| self.is_unit(*vector));
            if fits.is_none() {
                self.note(EventKind::VectorLength { length: norm(self.vector_of(own)) });
            }
            fits
        };
    }

    fn places(&self, component: usize) -> u8 {
        self.control.designation(b"PQR"[component]).map_or(0, |word| word.after)
    }

    fn vector_of(&self, increments: [i64; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| increments[axis] as f64 / power_of_ten(self.places(axis)) as f64)
    }

    /// The largest of the increments of P, Q and R that the format has.
    fn vector_increment(&self) -> f64 {
        let has = |axis: &usize| self.control.designation(b"PQR"[*axis]).is_some();
        (0..3).filter(has).map(|axis| 1.0 / power_of_ten(self.places(axis)) as f64).fold(0.0, f64::max)
    }

    /// Each of three components may be off by one increment: together by √3 of them.
    fn is_unit(&self, increments: [i64; 3]) -> bool {
        let length = norm(self.vector_of(increments));
        (length - 1.0).abs() <= 3.0_f64.sqrt() * self.vector_increment()
    }

    /// An arc without I, J and K whose P, Q and R, read in their place, put its end on a circle; whether they do by the
    /// reading that the format states.
    fn centre_in_vector(&self) -> Option<bool> {
        let Some(Motion::Circle { clockwise }) = self.motion else { return None };
        let [first, second, _] = self.plane.axes();
        let is_vector = self.control.vectors && self.is_unit(self.components.over([0; 3]));
        let given = |axis: usize| self.components.given[axis].is_some_and(|given| given.value != 0);
        if self.parametric || self.pending.is_some() || is_vector || !(given(first) || given(second)) {
            return None;
        }
        if self.is_doubtful([first, second]) || self.components.unread {
            return None;
        }
        let start = self.position;
        let mut block = self.arc_block(clockwise, &start);
        if block.start == block.end {
            return None;
        }
        block.tolerance = block.tolerance.max(super::circle::tolerance(self.vector_increment()));
        let centre = |reading: ArcCentre| {
            [first, second].map(|axis| {
                let (at, value) = (self.in_unit(axis, start[axis]), self.components.given[axis]);
                let value = value.map(|given| given.value as f64 / power_of_ten(self.places(axis)) as f64);
                match (value, reading) {
                    (None, _) => at,
                    (Some(value), ArcCentre::Absolute) => value,
                    (Some(value), ArcCentre::ToStart) => at - value,
                    (Some(value), _) => at + value,
                }
            })
        };
        let readings = [ArcCentre::Absolute, ArcCentre::FromStart, ArcCentre::ToStart];
        let fits = |reading: ArcCentre| block.about(centre(reading)).is_ok();
        let own = [first, second].map(|axis| self.reading(axis));
        readings.into_iter().any(fits).then(|| own[0] == own[1] && readings.contains(&own[0]) && fits(own[0]))
    }

    /// Notes a vector that is not as it was declared, normal or tangent, to the start of a span that cuts.
    pub(super) fn check_vector(&mut self, geometry: &Geometry, from: [f64; 3], to: [f64; 3]) {
        let Some(vector) = self.compensation.vector.filter(|_| self.compensation.side != Side::Cancelled) else {
            return;
        };
        let Some((tangent, length)) = start_of(geometry, from, to) else { return };
        let vector = self.vector_of(vector);
        // The components are off by an increment each, the direction by the rounding of the points over their distance.
        let increment = (0..3).map(|axis| self.increment(axis)).fold(0.0, f64::max);
        let slack = 3.0_f64.sqrt() * self.vector_increment() + super::circle::tolerance(increment) / length;
        let along: f64 = (0..3).map(|axis| vector[axis] * tangent[axis]).sum();
        let across = norm(super::parabola::cross(vector, tangent));
        let tangential = self.control.compensation_vector == CompensationVector::Tangent;
        let (off, other) = if tangential { (across, along.abs()) } else { (along.abs(), across) };
        if off > slack {
            self.note(EventKind::VectorAside { tangential, other: other <= slack });
        }
    }

    /// How the cutter's centre lies off the span that is made now.
    pub(super) fn offset(&self) -> Offset {
        match (self.compensation.side, self.compensation.vector) {
            (Side::Cancelled, _) => Offset::None,
            (_, Some(vector)) if self.control.compensation_vector == CompensationVector::Normal => {
                Offset::Along(self.vector_of(vector))
            }
            (Side::Left, _) => Offset::Left(self.plane),
            (Side::Right, _) => Offset::Right(self.plane),
            (Side::Unsaid, _) => Offset::None,
        }
    }
}

/// The direction in which a span starts, and the distance over which its points say it.
fn start_of(geometry: &Geometry, from: [f64; 3], to: [f64; 3]) -> Option<([f64; 3], f64)> {
    let chord: [f64; 3] = std::array::from_fn(|axis| to[axis] - from[axis]);
    let (way, distance) = match geometry {
        Geometry::Line => (chord, norm(chord)),
        Geometry::Arc(arc) => {
            let [first, second, third] = arc.plane.axes();
            let (cosine, sine) = (libm::cos(arc.start_angle), libm::sin(arc.start_angle));
            let mut way = [0.0; 3];
            way[first] = -sine * arc.start_radius * arc.sweep;
            way[second] = cosine * arc.start_radius * arc.sweep;
            way[third] = chord[third];
            (way, arc.start_radius)
        }
        // A curve starts towards its first control point.
        Geometry::Parabola { tangent } | Geometry::Curve { control: [tangent, _] } => {
            let way: [f64; 3] = std::array::from_fn(|axis| tangent[axis] - from[axis]);
            (way, norm(way))
        }
    };
    let length = norm(way);
    (length > 0.0 && distance > 0.0).then(|| (way.map(|part| part / length), distance))
}
