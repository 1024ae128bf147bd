//! Spans as motions of LinuxCNC.

use super::Writer;
use super::words::{coordinate, offset, plain};
use crate::execute::FeedInForce;
use crate::flatten::flatten;
use crate::format::{Angles, Plane, Unit, power_of_ten};
use crate::span::{Arc, Geometry, Span, SpanKind};
use std::f64::consts::TAU;
use std::fmt::Write;

/// The greatest difference of an arc's radii that LinuxCNC accepts, as its manual states it: in millimetres, in inches,
/// and beyond those as a share of the radius.
const RADIUS_MILLIMETRES: f64 = 0.005;
const RADIUS_INCHES: f64 = 0.0005;
const RADIUS_SHARE: f64 = 0.001;

/// Chords of a whole tape at the most: some 40 MB of text.
const MOST_CHORDS: usize = 1 << 20;

/// Why a span is not written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refusal {
    /// The tape does not say what it is.
    Substitute,
    /// A thread whose lead changes, or is not known.
    Thread,
    /// It would take too many chords.
    Long,
}

impl Writer<'_> {
    /// The line of motion of a span; `None` where no axis that LinuxCNC has moves.
    pub(super) fn span(&mut self, index: usize) -> Result<(), Refusal> {
        let span = &self.tape.spans().list[index];
        if span.kind == SpanKind::Dwell {
            return Ok(());
        }
        if span.substitute {
            return Err(Refusal::Substitute);
        }
        let ends = self.ends(index);
        match span.geometry {
            Geometry::Line if span.kind == SpanKind::Rapid => self.straight("G0", &ends, None),
            Geometry::Line if self.follow.is_thread() => {
                let lead = self.follow.lead(span.length).filter(|lead| sane(*lead)).ok_or(Refusal::Thread)?;
                self.straight(&format!("G33 K{}", plain(lead)), &ends, None);
            }
            Geometry::Line => {
                let feed = self.feed(span, true);
                self.straight("G1", &ends, Some(feed));
            }
            Geometry::Arc(arc) if self.accepts(&arc) => self.arc(span, &arc, &ends),
            Geometry::Parabola { tangent } if self.is_flat(span, tangent, &ends) => {
                let [i, j] = [0, 1].map(|axis| offset(tangent[axis] - span.start[axis]));
                let [x, y] = [0, 1].map(|axis| coordinate(span.end[axis], self.tape.control().axes[axis].decimals));
                let plane = self.plane(Plane::Xy);
                let feed = self.feed(span, false);
                self.motion(&format!("{plane}G5.1 X{x} Y{y} I{i} J{j}"), Some(feed));
            }
            _ => self.chords(index, &ends)?,
        }
        Ok(())
    }

    /// Where the axes that LinuxCNC has are at the ends of a span: letter, start, end, whether the block names it, places.
    fn ends(&self, index: usize) -> Vec<Axis> {
        let (start, end) = (self.tape.spans().start(index), self.tape.spans().end(index));
        (0..start.len()).filter_map(|axis| self.axis(axis, start[axis], end[axis])).collect()
    }

    /// An axis that LinuxCNC has; rotary ones in degrees.
    pub(super) fn axis(&self, axis: usize, start: f64, end: f64) -> Option<Axis> {
        let control = self.tape.control();
        let letter = control.axes[axis].letter;
        if !super::is_axis(letter) {
            return None;
        }
        let degrees = if "ABC".contains(letter) && control.angles() == Angles::Turns { 360.0 } else { 1.0 };
        Some(Axis {
            letter,
            start: start * degrees,
            end: end * degrees,
            addressed: self.follow.addressed(axis),
            decimals: control.axes[axis].decimals,
        })
    }

    /// A straight motion of every axis that moves or that the block names.
    pub(super) fn straight(&mut self, code: &str, ends: &[Axis], feed: Option<Feed>) {
        let words = ends.iter().filter(|axis| axis.addressed || axis.moves()).map(Axis::word);
        let words: String = words.collect();
        if !words.is_empty() {
            self.motion(&format!("{code}{words}"), feed);
        }
    }

    fn arc(&mut self, span: &Span, arc: &Arc, ends: &[Axis]) {
        let [first, second, third] = arc.plane.axes();
        let mut words = self.plane(arc.plane);
        words.push_str(if arc.sweep < 0.0 { "G2" } else { "G3" });
        for (axis, end) in ends.iter().enumerate() {
            let in_plane = axis == first || axis == second;
            if in_plane || end.moves() || axis == third && end.addressed {
                words.push_str(&end.word());
            }
        }
        for (axis, centre) in [(first, arc.centre[0]), (second, arc.centre[1])] {
            let _ = write!(words, " {}{}", ["I", "J", "K"][axis], offset(centre - span.start[axis]));
        }
        // Beyond one turn LinuxCNC counts the turns.
        if arc.sweep.abs() > TAU * 1.000_001 {
            let _ = write!(words, " P{}", (arc.sweep.abs() / TAU).ceil());
        }
        let feed = self.feed(span, true);
        self.motion(&words, Some(feed));
    }

    /// LinuxCNC accepts the radii of the arc.
    fn accepts(&self, arc: &Arc) -> bool {
        let difference = (arc.start_radius - arc.end_radius).abs();
        let (least, most) = match self.tape.control().unit {
            Unit::Inch => (RADIUS_INCHES, 100.0 * RADIUS_INCHES),
            Unit::Millimetre => (RADIUS_MILLIMETRES, 100.0 * RADIUS_MILLIMETRES),
        };
        difference <= least || difference <= most.min(RADIUS_SHARE * arc.start_radius.min(arc.end_radius))
    }

    /// A parabola in XY along which nothing else moves.
    fn is_flat(&self, span: &Span, tangent: [f64; 3], ends: &[Axis]) -> bool {
        tangent[2] == span.start[2] && ends.iter().all(|axis| "XY".contains(axis.letter) || !axis.moves())
    }

    /// A curve as straight cuts, and the other axes in proportion to the path.
    fn chords(&mut self, index: usize, ends: &[Axis]) -> Result<(), Refusal> {
        let spans = &self.tape.spans().list;
        let (span, decimals) = (&spans[index], self.chord_places());
        // The coordinates of the points are rounded, too.
        let points = flatten(spans, index..index + 1, self.chord_tolerance() * 0.9).xyz;
        let count = points.len() / 3 - 1;
        self.chords += count;
        if self.chords > MOST_CHORDS {
            return Err(Refusal::Long);
        }
        self.chorded.push((index, count));
        let feed = self.feed(span, false);
        for (number, point) in points.chunks_exact(3).enumerate().skip(1) {
            let last = number == count;
            let share = number as f64 / count as f64;
            let mut words = "G1".to_owned();
            for end in ends.iter().filter(|end| end.moves() || "XYZ".contains(end.letter)) {
                let place = "XYZ".find(end.letter);
                if place.is_some_and(|axis| is_constant(&points, axis)) {
                    continue;
                }
                let at = place.map_or(end.start + share * (end.end - end.start), |axis| point[axis]);
                match last {
                    true => words.push_str(&end.word()),
                    false => {
                        let _ = write!(words, " {}{}", end.letter, coordinate(at, decimals.max(end.decimals)));
                    }
                }
            }
            self.motion(&words, Some(feed.clone()));
        }
        Ok(())
    }

    /// How far chords may be off: half the coarsest least input increment of X, Y and Z, as far as the tape itself may
    /// be off; not below what any machine shows.
    pub(super) fn chord_tolerance(&self) -> f64 {
        let control = self.tape.control();
        let written = control.axes.iter().take(3).filter(|axis| axis.sign.is_some());
        let places = written.map(|axis| axis.decimals).min().unwrap_or(3);
        let finest = if control.unit == Unit::Inch { 0.000_02 } else { 0.000_5 };
        (0.5 / power_of_ten(places) as f64).max(finest)
    }

    /// Decimal places whose rounding is a twentieth of that at the most.
    fn chord_places(&self) -> u8 {
        let tolerance = self.chord_tolerance();
        (1..=9).find(|&places| 0.5 / power_of_ten(places) as f64 <= tolerance * 0.05).unwrap_or(9)
    }

    /// The plane word, where another plane is in force.
    fn plane(&mut self, plane: Plane) -> String {
        if self.in_force.plane.replace(plane) == Some(plane) {
            return String::new();
        }
        match plane {
            Plane::Xy => "G17 ",
            Plane::Zx => "G18 ",
            Plane::Yz => "G19 ",
        }
        .to_owned()
    }

    /// What the feed of a span is in LinuxCNC. `by_time`: the motion may state its own time (G93).
    fn feed(&self, span: &Span, by_time: bool) -> Feed {
        let minutes = span.seconds.map(|seconds| seconds / 60.0);
        let by_minutes = |minutes: f64| Feed::of(93, 1.0 / minutes);
        match (self.follow.feed(), span.feed) {
            // Under G94 the feed of a rotary axis alone is in degrees, whatever the tape has.
            _ if span.is_still() => minutes.map_or(Feed::Unknown, by_minutes),
            (FeedInForce::Reciprocal(_), _) if by_time => minutes.map_or(Feed::Unknown, by_minutes),
            (FeedInForce::PerRevolution(feed), _) => Feed::of(95, feed),
            (FeedInForce::PerMinute(_) | FeedInForce::Reciprocal(_) | FeedInForce::Rapid, Some(feed)) => {
                Feed::of(94, feed)
            }
            _ => Feed::Unknown,
        }
    }

    /// The feed of a motion over no distance, which has no time.
    pub(super) fn feed_in_force(&self) -> Feed {
        match self.follow.feed() {
            FeedInForce::Unknown | FeedInForce::Rapid => Feed::Unknown,
            FeedInForce::PerMinute(feed) => Feed::of(94, feed),
            FeedInForce::PerRevolution(feed) => Feed::of(95, feed),
            FeedInForce::Reciprocal(rate) => Feed::of(93, rate),
        }
    }

    /// Writes a motion, with its feed where it is a cut.
    fn motion(&mut self, words: &str, feed: Option<Feed>) {
        let line = match feed {
            None => words.to_owned(),
            Some(Feed::Known(mode, value)) => {
                let in_force = &mut self.in_force;
                let mode =
                    if in_force.feed_mode.replace(mode) == Some(mode) { String::new() } else { format!("G{mode} ") };
                // Every block has its own under G93.
                let own = !mode.is_empty() || in_force.feed_mode == Some(93) || in_force.feed.as_ref() != Some(&value);
                let feed = if own { format!(" F{value}") } else { String::new() };
                in_force.feed = Some(value);
                format!("{mode}{words}{feed}")
            }
            Some(Feed::Unknown) => {
                // LinuxCNC refuses to cut at no feed: better than at one that the tape does not say.
                self.no_feed = true;
                let mode = if self.in_force.feed_mode.replace(94) == Some(94) { "" } else { "G94 " };
                self.in_force.feed = None;
                format!("{mode}{words} F0")
            }
        };
        self.output.line(&line);
    }
}

/// The coordinate of an axis is the same in all points.
fn is_constant(points: &[f64], axis: usize) -> bool {
    points[axis..].iter().step_by(3).all(|at| *at == points[axis])
}

/// An F that a machine can take: what is beyond has slipped.
fn sane(value: f64) -> bool {
    (1e-9..1e9).contains(&value)
}

/// The feed of a motion: G93, G94 or G95 and the number.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Feed {
    Known(u8, String),
    Unknown,
}

impl Feed {
    fn of(mode: u8, value: f64) -> Feed {
        if sane(value) { Feed::Known(mode, plain(value)) } else { Feed::Unknown }
    }
}

/// An axis of LinuxCNC at the ends of a motion.
pub(super) struct Axis {
    letter: char,
    start: f64,
    end: f64,
    /// The block names it.
    addressed: bool,
    decimals: u8,
}

impl Axis {
    fn moves(&self) -> bool {
        self.start != self.end
    }

    fn word(&self) -> String {
        format!(" {}{}", self.letter, coordinate(self.end, self.decimals))
    }
}
