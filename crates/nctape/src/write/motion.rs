//! Motions as blocks of a format.

use super::{Fault, TapeWriter};
use crate::format::{
    ArcCentre, ArcFeed, ArcParameters, Control, Dimensions, FeedCoding, FeedUnit, ParabolaParameters, Plane, Sign,
    Standard,
};
use std::f64::consts::{FRAC_PI_2, PI};

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
    /// About a centre, first and second axis of the plane, by an angle in radians, counter-clockwise positive.
    Arc { plane: Plane, centre: [f64; 2], sweep: f64 },
    /// A parabola by the point where its tangents meet.
    Parabola { tangent: [f64; 3] },
}

/// How fast a motion is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Pace {
    /// Unit per minute along the path, beside the minutes that the motion takes.
    PerMinute { feed: f64, minutes: f64 },
    /// Unit per revolution of the spindle.
    PerRevolution(f64),
}

/// The number that a time-reciprocal F says of a motion that takes so many minutes; any other feed is itself.
pub(super) fn rate(control: &Control, value: f64, sweep: Option<f64>) -> f64 {
    match (control.feed, sweep, control.arc_feed) {
        (FeedCoding::TimeReciprocal, Some(sweep), ArcFeed::Radians) => sweep.abs() / value,
        (FeedCoding::TimeReciprocal, ..) => 1.0 / value,
        _ => value,
    }
}

impl TapeWriter<'_> {
    /// Writes a motion: one block, or several where the format cannot say it in one.
    pub(crate) fn motion(&mut self, motion: &Move) -> Result<(), Fault> {
        let end = self.target(motion)?;
        match motion.course {
            Course::Rapid => self.straight(0, &end, motion, None),
            Course::Line => self.straight(1, &end, motion, None),
            Course::Arc { .. } | Course::Parabola { .. } if self.control.standard() == Standard::Iso1058 => {
                Err(Fault::NoContouring)
            }
            Course::Arc { plane, centre, sweep } => self.arc(plane, centre, sweep, &end, motion),
            Course::Parabola { tangent } => self.parabola(tangent, &end, motion),
        }
    }

    /// Where the motion ends, in least input increments.
    fn target(&mut self, motion: &Move) -> Result<Vec<i64>, Fault> {
        let mut end = self.at.clone();
        for (axis, value) in motion.end.iter().enumerate().take(end.len()) {
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

    fn is_incremental(&self, axis: usize) -> bool {
        let chosen = self.control.dimensions == Dimensions::Incremental;
        match self.control.axes[axis].sign {
            _ if self.control.standard() == Standard::Rs274 => chosen,
            Some(Sign::Incremental) => true,
            Some(Sign::Both) => chosen,
            _ => false,
        }
    }

    /// Dimension words of the axes that move or are named.
    fn dimensions(&self, end: &[i64], motion: &Move) -> Result<Vec<(char, String)>, Fault> {
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
    fn interpolation(&mut self, code: u8) -> Result<Option<(char, String)>, Fault> {
        if self.modal.motion == Some(code) {
            return Ok(None);
        }
        let word = self.code_word('G', i64::from(code))?;
        self.modal.motion = Some(code);
        Ok(Some(('G', word)))
    }

    /// The F word of a cut, where another is in force. `share`: how much of the motion the block is.
    fn feed(&mut self, motion: &Move, share: f64, sweep: Option<f64>) -> Result<Option<(char, String)>, Fault> {
        let reciprocal = self.control.feed == FeedCoding::TimeReciprocal;
        let value = match (motion.pace.ok_or(Fault::NoFeed)?, self.control.feed_unit) {
            (Pace::PerMinute { minutes, .. }, _) if reciprocal => minutes * share,
            (Pace::PerMinute { feed, .. }, FeedUnit::PerMinute) => feed,
            (Pace::PerRevolution(feed), FeedUnit::PerRevolution) if !reciprocal => feed,
            _ => return Err(Fault::NoFeed),
        };
        let word = self.speed_word('F', value, sweep)?;
        // Every block of a time-reciprocal feed has its own.
        if !reciprocal && self.modal.feed.as_ref() == Some(&word) {
            return Ok(None);
        }
        self.modal.feed = Some(word.clone());
        Ok(Some(('F', word)))
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

    fn arc(&mut self, plane: Plane, centre: [f64; 2], sweep: f64, end: &[i64], motion: &Move) -> Result<(), Fault> {
        let [first, second, third] = plane.axes();
        if end[third] != self.at[third] && !self.control.helix {
            return Err(Fault::Helix);
        }
        self.turn(plane)?;
        let by_centre = self.control.arc_parameters == ArcParameters::Centre
            && [first, second].iter().all(|&axis| self.designation(['I', 'J', 'K'][axis]).is_ok());
        let start: Vec<f64> = [first, second, third].iter().map(|&axis| self.position(axis)).collect();
        let from = [start[0] - centre[0], start[1] - centre[1]];
        let (radius, angle) = (libm::hypot(from[0], from[1]), libm::atan2(from[1], from[0]));
        let to = [first, second].map(|axis| crate::execute::in_unit(&self.control.axes[axis], end[axis]));
        let end_radius = libm::hypot(to[0] - centre[0], to[1] - centre[1]);
        // Where the arc is to be cut: at the axes of the circle for a control that stays within a quadrant; three points
        // make no full circle.
        let mut cuts: Vec<f64> = Vec::new();
        if by_centre && self.control.arc_centre == ArcCentre::Quadrant {
            let quarters = (-12..=12).map(|quarter: i32| f64::from(quarter) * FRAC_PI_2 - angle);
            let inside =
                |turn: &f64| turn.signum() == sweep.signum() && (1e-9..sweep.abs() - 1e-9).contains(&turn.abs());
            cuts = quarters.filter(inside).map(|turn| turn / sweep).collect();
            cuts.sort_by(f64::total_cmp);
        } else if !by_centre && sweep.abs() > PI {
            cuts.push(0.5);
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

    /// Puts a point of a plane into a position.
    fn place(&mut self, position: &mut [i64], axes: [usize; 2], point: [f64; 2]) -> Result<(), Fault> {
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

    /// I, J or K for a coordinate of a point, by the reading of the format.
    fn parameter(&mut self, axis: usize, value: f64) -> Result<(char, String), Fault> {
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

    fn parabola(&mut self, tangent: [f64; 3], end: &[i64], motion: &Move) -> Result<(), Fault> {
        let start: [f64; 3] = std::array::from_fn(|axis| self.position(axis));
        let to: [f64; 3] = std::array::from_fn(|axis| crate::execute::in_unit(&self.control.axes[axis], end[axis]));
        let used: Vec<usize> = (0..3).filter(|&axis| tangent[axis] != start[axis] || to[axis] != start[axis]).collect();
        let letters = used.iter().all(|&axis| self.designation(['I', 'J', 'K'][axis]).is_ok());
        if letters
            && self.control.parabola_parameters == ParabolaParameters::Tangent
            && self.control.arc_centre != ArcCentre::Quadrant
        {
            let mut words = self.dimensions(end, motion)?;
            for &axis in &used {
                words.push(self.parameter(axis, tangent[axis])?);
            }
            words.extend(self.feed(motion, 1.0, None)?);
            words.extend(self.interpolation(6)?);
            self.block(words);
            self.at.copy_from_slice(end);
            return Ok(());
        }
        // By its point opposite the middle of the chord, which is halfway to where the tangents meet.
        let mut middle = end.to_vec();
        let kept = self.rounding;
        for axis in used {
            let (letter, decimals) = (self.control.axes[axis].letter, self.control.axes[axis].decimals);
            let at = (start[axis] + 2.0 * tangent[axis] + to[axis]) / 4.0;
            middle[axis] = self.increments(at, decimals, letter)?;
        }
        self.rounding = kept;
        self.two_blocks(6, &middle, end, motion, Part { share: 1.0, sweep: 0.0 })
    }

    /// A span by an intermediate point and its end. The F of the last block is that of the span.
    fn two_blocks(&mut self, code: u8, middle: &[i64], end: &[i64], motion: &Move, part: Part) -> Result<(), Fault> {
        let sweep = (code != 6).then_some(part.sweep);
        for point in [middle, end] {
            let mut words = self.dimensions(point, motion)?;
            words.extend(self.feed(motion, part.share, sweep)?);
            words.extend(self.interpolation(code)?);
            self.block(words);
            self.at.copy_from_slice(point);
        }
        Ok(())
    }

    /// Turns to another plane, in a block of its own: a block has one G.
    fn turn(&mut self, plane: Plane) -> Result<(), Fault> {
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
struct Part {
    share: f64,
    sweep: f64,
}
