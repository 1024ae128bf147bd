//! Moves, and what must be so before one.

use super::cycle::CycleState;
use super::posting::Poster;
use crate::cldata::execution::Per;
use crate::cldata::step::Motion;
use crate::diagnostic::Fix;
use crate::format::{FeedCoding, FeedUnit, SetPoint, Standard};
use crate::rules::{conversion, posting as rules};
use crate::write::{Course, Move, Pace};
use std::ops::Range;

/// A tool axis this near to Z is Z: a thousandth of a millimetre over a metre of tool.
const UPRIGHT: f64 = 1e-6;

/// How fast a motion is: the feed in the unit of the format, and what it is counted per.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate {
    pub feed: Option<f64>,
    pub per: Per,
    /// Revolutions per minute.
    pub speed: Option<f64>,
}

impl Poster<'_> {
    pub(super) fn motion(&mut self, motion: &Motion) {
        let place = self.source.elements(motion.element..motion.element + 3);
        if !motion.sound {
            let message = "Where this motion goes is not known: a coordinate cannot be read, or the ends of an arc \
                           are not on its circle.";
            self.lack(&rules::motion_not_posted::RULE, message, place, message.to_owned());
            return;
        }
        let axis = motion.axis.unwrap_or(self.state.tool_axis);
        if !is_upright(axis) {
            let [i, j, k] = axis;
            let message = format!(
                "The tool axis is ({i}, {j}, {k}) here, and this tape has none but (0, 0, 1): which rotary positions \
                 make it is a matter of the machine, and the format does not say."
            );
            let own = motion.element + 3..motion.element + 6;
            let place = if motion.axis.is_some() { self.source.elements(own) } else { place };
            self.lack(&rules::tilted_tool_axis::RULE, "axis", place, message);
            return;
        }
        let to = self.point(motion.to);
        let rate = Rate { feed: motion.feed.map(|feed| self.length(feed)), per: motion.per, speed: motion.speed };
        self.begin(motion, &place);
        let is_hole = !motion.rapid && motion.arc.is_none();
        match self.state.cycle.clone() {
            CycleState::On(cycle) if is_hole => self.hole(&cycle, to, rate, place),
            // What the cycle lacks was said where it was set.
            CycleState::Refused if is_hole => {}
            _ => {
                self.restart(&place);
                match motion.arc {
                    Some(arc) => self.arc(&arc, motion, rate, place),
                    None if motion.rapid => {
                        self.rapid(to, place);
                    }
                    None => {
                        self.cut(to, rate, place);
                    }
                }
            }
        }
    }

    /// Before the first motion of a program the tool goes to where the text says that it stands.
    fn begin(&mut self, motion: &Motion, place: &Range<usize>) {
        if std::mem::replace(&mut self.state.begun, true) {
            return;
        }
        let start = self.state.from.map_or(motion.to, |(_, at)| at);
        let from = self.point(start);
        for (axis, &value) in from.iter().enumerate() {
            // An axis that the format lacks stands where it is needed, as a hand sets it.
            if self.control.axes[axis].sign.is_none() {
                self.writer.stand_by_hand(axis, value);
            }
        }
        let Some((record, _)) = self.state.from.filter(|_| !self.is_at(from)) else { return };
        let stands: [f64; 3] = std::array::from_fn(|axis| self.writer.position(axis));
        let shown = |[x, y, z]: [f64; 3]| format!("({x}, {y}, {z})");
        let message = format!(
            "The text begins at {}, and under this format the tool stands at {}: a block takes it there.",
            shown(from),
            shown(stands)
        );
        self.report(&rules::start_elsewhere::RULE, "", self.source.record(record), message);
        if self.source.cldata.records()[record].file == 0 {
            let fix = self.set_point_fix(from);
            self.last_finding().into_iter().for_each(|finding| finding.fixes.push(fix.clone()));
        }
        self.rapid(from, place.clone());
    }

    /// The format with another set point.
    fn set_point_fix(&self, from: [f64; 3]) -> Fix {
        let mut format = self.control.format.clone();
        let axes = self.control.axes.iter().take(3).zip(from).filter(|(axis, _)| axis.sign.is_some());
        format.itemized.set_point =
            Some(SetPoint::Named(axes.map(|(axis, value)| (axis.letter.to_string(), value)).collect()));
        Fix::reformat("Take it as the set point of the format", format)
    }

    fn is_at(&self, point: [f64; 3]) -> bool {
        (0..3).all(|axis| self.stands_at(axis, point[axis]))
    }

    /// An axis stands within half an increment of a value.
    pub(super) fn stands_at(&self, axis: usize, value: f64) -> bool {
        self.writer.nearest(axis, value) == self.writer.position(axis)
    }

    /// The words of a move: those of the axes that move, and of those whose last word may not have been read.
    pub(super) fn named(&self, to: [f64; 3]) -> Vec<Option<f64>> {
        let mut end = vec![None; self.control.axes.len()];
        for axis in 0..3 {
            let is_needed = self.state.unsaid[axis] && self.control.axes[axis].sign.is_some();
            if is_needed || !self.stands_at(axis, to[axis]) {
                end[axis] = Some(to[axis]);
            }
        }
        end
    }

    /// Every axis has been said, if not in a block that may be skipped.
    pub(super) fn said_axes(&mut self) {
        self.state.unsaid = [self.writer.skip; 3];
    }

    /// Positions the tool. True where nothing is lacking.
    pub(super) fn rapid(&mut self, to: [f64; 3], place: Range<usize>) -> bool {
        let end = self.named(to);
        if end.iter().all(Option::is_none) {
            return true;
        }
        let written = self.writer.motion(&Move { course: Course::Rapid, end, pace: None });
        let is_written = self.take(written, place);
        if is_written {
            self.said_axes();
        }
        is_written
    }

    /// Cuts straight.
    pub(super) fn cut(&mut self, to: [f64; 3], rate: Rate, place: Range<usize>) -> bool {
        let end = self.named(to);
        let moving: Vec<usize> = (0..3).filter(|&axis| !self.stands_at(axis, to[axis])).collect();
        if moving.is_empty() {
            return true;
        }
        if let Some(message) = self.too_many(&moving) {
            self.lack(&conversion::does_not_fit::RULE, "", place, message);
            return false;
        }
        let way: [f64; 3] =
            std::array::from_fn(|axis| self.writer.nearest(axis, to[axis]) - self.writer.position(axis));
        let pace = self.pace(rate, libm::hypot(libm::hypot(way[0], way[1]), way[2]));
        let written = self.writer.motion(&Move { course: Course::Line, end, pace });
        let is_written = self.take(written, place);
        if is_written {
            self.said_axes();
        }
        is_written
    }

    /// Why these axes cannot cut at once.
    fn too_many(&self, moving: &[usize]) -> Option<String> {
        let letters: String = moving.iter().map(|&axis| self.control.axes[axis].letter).collect();
        match self.control.simultaneous() {
            _ if self.control.standard() == Standard::Iso1058 && moving.len() > 1 => {
                Some(format!("{letters} cut at once here, and a control of ISO 1058 cuts along one axis at a time."))
            }
            Some(most) if moving.len() > usize::from(most) => Some(format!(
                "{letters} move at once here, and the third digit of the classification allows {most} at a time."
            )),
            _ => None,
        }
    }

    /// The feed of a cut of some length, as the format counts it; none where it is not known.
    pub(super) fn pace(&self, rate: Rate, length: f64) -> Option<Pace> {
        let feed = rate.feed.filter(|feed| feed.is_finite() && *feed > 0.0)?;
        let speed = rate.speed.filter(|speed| *speed > 0.0);
        let is_reciprocal = self.control.feed == FeedCoding::TimeReciprocal;
        let by_revolution = self.control.feed_unit == FeedUnit::PerRevolution && !is_reciprocal;
        let per_minute = |feed: f64| Pace::PerMinute { feed, minutes: length / feed };
        // Where no speed is known, the kind of feed that the format does not have by itself (G94, G95).
        match (rate.per, by_revolution, speed) {
            (Per::Minute, true, Some(speed)) => Some(Pace::PerRevolution(feed / speed)),
            (Per::Minute, ..) => Some(per_minute(feed)),
            (Per::Revolution, false, Some(speed)) => Some(per_minute(feed * speed)),
            (Per::Revolution, ..) => Some(Pace::PerRevolution(feed)),
            (Per::Other, ..) => None,
        }
    }
}

fn is_upright(axis: [f64; 3]) -> bool {
    let [i, j, k] = axis;
    let length = libm::hypot(libm::hypot(i, j), k);
    length > 0.0 && k > 0.0 && libm::hypot(i, j) <= UPRIGHT * length
}
