//! Motions as blocks of a format.

use super::feed::Pace;
use super::{Fault, TapeWriter};
use crate::format::{ArcCentre, ArcParameters, Dimensions, Plane, Sign, Standard, power_of_ten};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A motion.
#[derive(Clone, Debug)]
pub(crate) struct Move {
    pub course: Course,
    /// Where it ends, axis by axis of the format and in its unit; `None` for an axis that is not named.
    pub end: Vec<Option<f64>>,
    /// How fast, where it is a cut.
    pub pace: Option<Pace>,
}

/// How a motion runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Course {
    /// Positioning.
    Rapid,
    /// Straight.
    Line,
    /// Straight, with so much along X, Y and Z at every revolution of the spindle: G33, or G34 and G35.
    Thread { code: u8, leads: [f64; 3] },
    /// About a centre, first and second axis of the plane, by an angle in radians, counter-clockwise positive.
    Arc { plane: Plane, centre: [f64; 2], sweep: f64 },
    /// A parabola by the point where its tangents meet.
    Parabola { tangent: [f64; 3] },
    /// A cubic by its control points.
    Cubic { control: [[f64; 3]; 2] },
}

impl TapeWriter<'_> {
    /// Writes a motion: one block, or several where the format cannot say it in one.
    pub(crate) fn motion(&mut self, motion: &Move) -> Result<(), Fault> {
        let end = self.target(motion)?;
        match motion.course {
            Course::Rapid => self.straight(0, &end, motion, None),
            Course::Line => self.straight(1, &end, motion, None),
            Course::Thread { code, leads } => self.thread(code, leads, &end, motion),
            Course::Arc { .. } | Course::Parabola { .. } | Course::Cubic { .. }
                if self.control.standard() == Standard::Iso1058 =>
            {
                Err(Fault::NoContouring)
            }
            Course::Arc { plane, centre, sweep } => self.arc(plane, centre, sweep, &end, motion),
            Course::Parabola { tangent } => self.parabola(tangent, &end, motion),
            Course::Cubic { control } => self.cubic(control, &end, motion),
        }
    }

    /// Where the motion ends, in least input increments.
    fn target(&mut self, motion: &Move) -> Result<Vec<i64>, Fault> {
        self.rounded(&motion.end)
    }

    /// A position in least input increments; an axis that is not given stands where it is.
    pub(super) fn rounded(&mut self, at: &[Option<f64>]) -> Result<Vec<i64>, Fault> {
        let mut end = self.at.clone();
        for (axis, value) in at.iter().enumerate().take(end.len()) {
            let Some(value) = *value else { continue };
            let (letter, decimals) = (self.control.axes[axis].letter, self.control.axes[axis].decimals);
            if self.control.axes[axis].sign.is_none() {
                // An axis that the format lacks may stand where it is.
                if value == self.position(axis) {
                    continue;
                }
                return Err(Fault::NoWord(letter));
            }
            end[axis] = self.increments(value, decimals, letter)?;
        }
        Ok(end)
    }

    pub(crate) fn is_incremental(&self, axis: usize) -> bool {
        let chosen = self.control.dimensions == Dimensions::Incremental;
        match self.control.axes[axis].sign {
            _ if self.control.standard() == Standard::Rs274 => chosen,
            Some(Sign::Incremental) => true,
            Some(Sign::Both) => chosen,
            _ => false,
        }
    }

    /// Dimension words of the axes that move or are named.
    pub(super) fn dimensions(&self, end: &[i64], motion: &Move) -> Result<Vec<(char, String)>, Fault> {
        let named = |axis: usize| motion.end.get(axis).is_some_and(Option::is_some);
        let mut words = Vec::new();
        for (axis, &to) in end.iter().enumerate() {
            let (incremental, moves) = (self.is_incremental(axis), to != self.at[axis]);
            if self.control.axes[axis].sign.is_none() || !(moves || named(axis) && !incremental) {
                continue;
            }
            let number = if incremental { to.saturating_sub(self.at[axis]) } else { to };
            let letter = self.control.axes[axis].letter;
            words.push((letter, self.dimension_word(letter, number)?));
        }
        Ok(words)
    }

    /// The code of the interpolation, where another is in force.
    pub(super) fn interpolation(&mut self, code: u8) -> Result<Option<(char, String)>, Fault> {
        // A format without G has the interpolation that its standard begins with.
        let standing = if self.control.standard() == Standard::Iso1058 { 0 } else { 1 };
        if self.designation('G').is_err() && code == standing {
            return Ok(None);
        }
        let word = self.code_word('G', i64::from(code))?;
        let once = self.once.take();
        if self.modal.motion == Some(code) {
            return once.map(|once| Ok(('G', self.code_word('G', once.into())?))).transpose();
        }
        self.modal.motion = Some(code);
        match once {
            // A block has one G: the interpolation stands before it in one of its own.
            Some(once) => {
                let once = self.code_word('G', i64::from(once))?;
                self.separate(('G', word));
                Ok(Some(('G', once)))
            }
            None => Ok(Some(('G', word))),
        }
    }

    fn straight(&mut self, code: u8, end: &[i64], motion: &Move, share: Option<f64>) -> Result<(), Fault> {
        let mut words = self.dimensions(end, motion)?;
        if words.is_empty() {
            return Ok(());
        }
        if code == 1 {
            words.extend(self.feed(motion, share.unwrap_or(1.0), None)?);
        }
        words.extend(self.interpolation(code)?);
        self.block(words);
        self.at.copy_from_slice(end);
        Ok(())
    }

    fn thread(&mut self, code: u8, leads: [f64; 3], end: &[i64], motion: &Move) -> Result<(), Fault> {
        let mut words = self.dimensions(end, motion)?;
        if words.is_empty() {
            return Ok(());
        }
        for (letter, lead) in ['I', 'J', 'K'].into_iter().zip(leads).filter(|(_, lead)| *lead != 0.0) {
            words.push((letter, self.plain_word(letter, lead)?));
        }
        // Without leads it is F that says the lead.
        if leads == [0.0; 3] {
            words.extend(self.feed(motion, 1.0, None)?);
        }
        words.extend(self.interpolation(code)?);
        self.block(words);
        self.at.copy_from_slice(end);
        Ok(())
    }

    fn arc(&mut self, plane: Plane, centre: [f64; 2], sweep: f64, end: &[i64], motion: &Move) -> Result<(), Fault> {
        let [first, second, third] = plane.axes();
        if end[third] != self.at[third] && !self.control.helix {
            return Err(Fault::Helix);
        }
        // An arc that is no longer than rounding may turn it about is as well a straight cut.
        let turn = |axis: usize| 1.0 / power_of_ten(self.control.axes[axis].decimals) as f64;
        let least = 2.0 * turn(first).max(turn(second));
        let reach = libm::hypot(self.position(first) - centre[0], self.position(second) - centre[1]);
        if sweep.abs() * reach <= least {
            return self.straight(1, end, motion, None);
        }
        self.turn(plane)?;
        let by_centre = self.arcs_by_centre(plane);
        let start: Vec<f64> = [first, second, third].iter().map(|&axis| self.position(axis)).collect();
        let from = [start[0] - centre[0], start[1] - centre[1]];
        let (radius, angle) = (libm::hypot(from[0], from[1]), libm::atan2(from[1], from[0]));
        let to = [first, second].map(|axis| crate::execute::in_unit(&self.control.axes[axis], end[axis]));
        let end_radius = libm::hypot(to[0] - centre[0], to[1] - centre[1]);
        // Where the arc is to be cut: at the axes of the circle for a control that stays within a quadrant; three points
        // make no full circle.
        let mut cuts: Vec<f64> = Vec::new();
        if by_centre && (self.quadrants || self.control.arc_centre == ArcCentre::Quadrant) {
            let quarters = (-12..=12).map(|quarter: i32| f64::from(quarter) * FRAC_PI_2 - angle);
            let inside =
                |turn: &f64| turn.signum() == sweep.signum() && (1e-9..sweep.abs() - 1e-9).contains(&turn.abs());
            cuts = quarters.filter(inside).map(|turn| turn / sweep).collect();
            cuts.sort_by(f64::total_cmp);
        } else if !by_centre && sweep.abs() > PI {
            cuts.push(0.5);
        } else if by_centre {
            let closed = end[first] == self.at[first] && end[second] == self.at[second];
            // A control without full circles; ends so near to one another that rounding may swap them; and a spiral of
            // more than half a turn, of which no one circle is near.
            let refused = closed && self.control.format.itemized.full_circle == Some(false);
            let nearly = !closed && (TAU - sweep.abs()) * radius <= least;
            let spiral = sweep.abs() > PI && (radius - end_radius).abs() > least / 2.0;
            cuts.extend((refused || nearly || spiral).then_some(0.5));
        }
        cuts.push(1.0);
        let third_start = self.at[third];
        let mut before = 0.0;
        for share in cuts {
            let point = |share: f64| -> [f64; 2] {
                let (turn, radius) = (angle + share * sweep, radius + share * (end_radius - radius));
                [centre[0] + radius * libm::cos(turn), centre[1] + radius * libm::sin(turn)]
            };
            let mut piece = end.to_vec();
            if share < 1.0 {
                self.place(&mut piece, [first, second], point(share))?;
                piece[third] = third_start + (share * (end[third] - third_start) as f64).round() as i64;
            }
            let part = Part { share: share - before, sweep: sweep * (share - before) };
            match by_centre {
                true => self.arc_by_centre([first, second], centre, &piece, motion, part)?,
                false => {
                    let mut middle = piece.clone();
                    self.place(&mut middle, [first, second], point((before + share) / 2.0))?;
                    middle[third] = self.at[third];
                    let code = if sweep < 0.0 { 2 } else { 3 };
                    self.two_blocks(code, &middle, &piece, motion, part)?;
                }
            }
            before = share;
        }
        Ok(())
    }

    /// Arcs are said by their centre; otherwise by three points.
    pub(crate) fn arcs_by_centre(&self, plane: Plane) -> bool {
        let [first, second, _] = plane.axes();
        self.control.arc_parameters == ArcParameters::Centre
            && [first, second].iter().all(|&axis| self.designation(['I', 'J', 'K'][axis]).is_ok())
    }

    /// Puts a point of a plane into a position.
    pub(super) fn place(&mut self, position: &mut [i64], axes: [usize; 2], point: [f64; 2]) -> Result<(), Fault> {
        let kept = self.rounding;
        for (axis, value) in axes.into_iter().zip(point) {
            let (letter, decimals) = (self.control.axes[axis].letter, self.control.axes[axis].decimals);
            position[axis] = self.increments(value, decimals, letter)?;
        }
        // A point that the format makes necessary lies on no increment, and no one has given it.
        self.rounding = kept;
        Ok(())
    }

    fn arc_by_centre(
        &mut self,
        axes: [usize; 2],
        centre: [f64; 2],
        end: &[i64],
        motion: &Move,
        part: Part,
    ) -> Result<(), Fault> {
        let centre = self.fitted(axes, centre, end);
        let mut words = self.dimensions(end, motion)?;
        for (axis, centre) in axes.into_iter().zip(centre) {
            words.push(self.parameter(axis, centre)?);
        }
        let code = if part.sweep < 0.0 { 2 } else { 3 };
        words.extend(self.feed(motion, part.share, Some(part.sweep))?);
        words.extend(self.interpolation(code)?);
        self.block(words);
        self.at.copy_from_slice(end);
        Ok(())
    }

    /// A centre that is as far from the start as from the end. One that comes from a coarser tape may differ by more than
    /// this format allows: it goes along the chord to where both are equal. Over half a turn at most the circle is then no
    /// further off than half of that difference.
    fn fitted(&self, axes: [usize; 2], centre: [f64; 2], end: &[i64]) -> [f64; 2] {
        let from = axes.map(|axis| self.position(axis));
        let to = axes.map(|axis| crate::execute::in_unit(&self.control.axes[axis], end[axis]));
        let radius = |at: [f64; 2]| libm::hypot(at[0] - centre[0], at[1] - centre[1]);
        let chord = [to[0] - from[0], to[1] - from[1]];
        let length = libm::hypot(chord[0], chord[1]);
        let (start, stop) = (radius(from), radius(to));
        let step = 1.0 / power_of_ten(self.control.axes[axes[0]].decimals) as f64;
        if length == 0.0 || (start - stop).abs() <= step {
            return centre;
        }
        // |C - A| = |C - B| with C on the line through the centre along the chord.
        let way = (stop - start) * (stop + start) / (2.0 * length) / length;
        [centre[0] + way * chord[0], centre[1] + way * chord[1]]
    }

    /// I, J or K for a coordinate of a point, by the reading of the format.
    pub(super) fn parameter(&mut self, axis: usize, value: f64) -> Result<(char, String), Fault> {
        let letter = ['I', 'J', 'K'][axis];
        let places = self.designation(letter)?.after;
        let start = self.position(axis);
        let number = match self.control.arc_centre {
            ArcCentre::Absolute => value,
            ArcCentre::AsDimensions if !self.is_incremental(axis) => value,
            ArcCentre::AsDimensions | ArcCentre::FromStart => value - start,
            ArcCentre::ToStart => start - value,
            ArcCentre::Quadrant => (value - start).abs(),
        };
        // What a decimal number loses on the way through binary is no rounding of the tape.
        let number = (number * 1e9).round() / 1e9;
        let number = self.increments(number, places, letter)?;
        Ok((letter, self.dimension_word(letter, number)?))
    }

    /// Turns to another plane, in a block of its own: a block has one G.
    pub(crate) fn turn(&mut self, plane: Plane) -> Result<(), Fault> {
        if self.modal.plane == Some(plane) {
            return Ok(());
        }
        let code = match plane {
            Plane::Xy => 17,
            Plane::Zx => 18,
            Plane::Yz => 19,
        };
        self.function('G', code)?;
        self.modal.plane = Some(plane);
        Ok(())
    }
}

/// A piece of an arc: how much of it, and its angle.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub share: f64,
    pub sweep: f64,
}
