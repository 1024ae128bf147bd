//! What the control holds from block to block: modal functions, position, feed.

use super::compensation::{Compensation, Components, Side};
use super::dwell::Pause;
use super::event::{Event, EventKind, Several};
use super::feed::{self, CodeFault, Feed};
use super::is_carried_out;
use super::mark::Carried;
use super::position::Position;
use crate::format::{Axis, Control, Dimensions, FeedCoding, FeedUnit, Plane, Sign, Standard, power_of_ten};
use crate::function::{Group, Preparatory, preparatory};
use crate::read::Word;
use crate::span::Spans;

/// How the tool moves: the functions of group a.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Motion {
    /// G00.
    Rapid,
    /// G01.
    Line,
    /// G33, whose lead is constant, and G34 and G35, whose lead changes; the path is a line.
    Thread { constant: bool },
    /// G02 and G03.
    Circle { clockwise: bool },
    /// G06.
    Parabola,
    /// A G code that the itemized data declares as a curve of higher order.
    Curve { code: u8 },
}

/// The points of a span whose last block is still to come; the tool stands on the last one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pending {
    /// The first block.
    pub block: usize,
    /// The block of the last point.
    pub last: usize,
    pub start: Position,
    /// The first point, where it is not the last.
    pub middle: Option<Position>,
    pub several: Several,
    /// A word of a block could not be read, or the start is a guess.
    pub doubtful: bool,
}

/// A word of the block with its number in least input increments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parameter {
    pub place: usize,
    pub value: i64,
}

/// What the modal words of earlier blocks set.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mode {
    motion: Option<Motion>,
    plane: Plane,
    incremental: bool,
    feed: Feed,
    speed: Option<f64>,
    cutting_speed: bool,
    coding: FeedCoding,
    unit: FeedUnit,
    compensation: Compensation,
    leads: [i64; 3],
}

pub(crate) struct State<'a> {
    pub control: &'a Control,
    pub motion: Option<Motion>,
    pub plane: Plane,
    pub incremental: bool,
    pub feed: Feed,
    pub speed: Option<f64>,
    /// S is a cutting speed: G96.
    cutting_speed: bool,
    /// An S word was given, readable or not.
    any_speed: bool,
    coding: FeedCoding,
    unit: FeedUnit,
    pub compensation: Compensation,
    /// Where every axis is, in least input increments.
    pub position: Position,
    pub pending: Option<Pending>,
    /// I, J and K of the last thread that gave some, in least input increments.
    pub leads: [i64; 3],

    pub block: usize,
    /// Where the block takes every axis.
    pub target: Position,
    /// The block has a dimension word that can be used; the place of the last one for each axis.
    pub words: Vec<Option<usize>>,
    /// I, J and K of the block.
    pub parameters: [Option<Parameter>; 3],
    /// The F word of the block: its place, and its number where it has all digits.
    pub own_feed: Option<(usize, Option<i64>)>,
    /// P, Q and R of the block.
    pub components: Components,
    /// They are the centre of its arc.
    pub centre_in_vector: bool,
    /// The block has a dimension word, readable or not.
    pub addressed: bool,
    /// The block has an interpolation parameter, readable or not.
    pub parametric: bool,
    /// A dimension word or parameter of the block could not be read.
    unread: bool,
    /// The axes whose position is a guess, because a word of theirs could not be read: now, and at the start of the
    /// block. Bit by bit; an axis beyond 32 is taken as known.
    lost: u32,
    lost_at_start: u32,
    motionless: bool,
    preload: bool,
    /// The block dwells by a word that the format states.
    pub dwells: bool,
    /// That word.
    pub pause: Option<Pause>,
    /// A preparatory function could not be read or is not assigned, and was reported: it may have been the
    /// interpolation code.
    pub lost_function: bool,

    pub spans: Spans,
    pub events: Vec<Event>,
    /// There was a span before those.
    moved_before: bool,
}

impl<'a> State<'a> {
    pub(crate) fn new(control: &'a Control) -> Self {
        let axes = control.axes.len();
        State {
            control,
            motion: None,
            plane: control.plane,
            incremental: control.dimensions == Dimensions::Incremental,
            feed: Feed::None,
            speed: None,
            cutting_speed: false,
            any_speed: false,
            coding: control.feed,
            unit: control.feed_unit,
            compensation: Compensation::NONE,
            position: Position::new(&control.set_point),
            pending: None,
            block: 0,
            target: Position::new(&control.set_point),
            words: vec![None; axes],
            parameters: [None; 3],
            own_feed: None,
            components: Components::default(),
            centre_in_vector: false,
            addressed: false,
            parametric: false,
            unread: false,
            lost: 0,
            lost_at_start: 0,
            motionless: false,
            preload: false,
            dwells: false,
            pause: None,
            leads: [0; 3],
            lost_function: false,
            spans: Spans::new(axes, control.compensates()),
            events: Vec::new(),
            moved_before: false,
        }
    }

    /// Back to the modal state of the start, as a new program on the tape finds it; the tool stays where it is.
    pub(crate) fn restart(&mut self) {
        let (spans, events) = (std::mem::take(&mut self.spans), std::mem::take(&mut self.events));
        *self = State {
            position: self.position,
            spans,
            events,
            moved_before: self.moved_before,
            ..State::new(self.control)
        };
    }

    /// What it carries into the next block of the program.
    pub(super) fn carried(&self) -> Carried {
        let State { motion, plane, incremental, feed, speed, cutting_speed, any_speed, coding, unit, .. } = *self;
        Carried {
            motion,
            plane,
            incremental,
            feed,
            speed,
            cutting_speed,
            any_speed,
            coding,
            unit,
            compensation: self.compensation,
            position: self.position,
            pending: self.pending,
            leads: self.leads,
            lost: self.lost,
            // Once there is an interpolation code it is no matter.
            lost_function: self.lost_function && motion.is_none(),
            moved: self.moved(),
            ended: false,
        }
    }

    /// Goes on from what another carried.
    pub(super) fn take_over(&mut self, carried: &Carried) {
        let Carried { motion, plane, incremental, feed, speed, cutting_speed, any_speed, coding, unit, .. } = *carried;
        (self.motion, self.plane, self.incremental) = (motion, plane, incremental);
        (self.feed, self.speed, self.cutting_speed, self.any_speed) = (feed, speed, cutting_speed, any_speed);
        (self.coding, self.unit) = (coding, unit);
        self.compensation = carried.compensation;
        (self.position, self.pending, self.lost) = (carried.position, carried.pending, carried.lost);
        (self.leads, self.lost_function) = (carried.leads, carried.lost_function);
        self.moved_before = carried.moved;
    }

    /// The tape has a span already.
    pub(super) fn moved(&self) -> bool {
        self.moved_before || !self.spans.list.is_empty()
    }

    /// Notes a motion of which nothing can be drawn.
    pub(super) fn leave_out(&mut self, holds: bool) {
        if holds {
            self.note(EventKind::LeftOut);
        }
    }

    pub(crate) fn mode(&self) -> Mode {
        let State { motion, plane, incremental, feed, speed, cutting_speed, coding, unit, compensation, leads, .. } =
            *self;
        Mode { motion, plane, incremental, feed, speed, cutting_speed, coding, unit, compensation, leads }
    }

    pub(crate) fn note(&mut self, kind: EventKind) {
        self.events.push(Event { block: self.block, kind });
    }

    pub(crate) fn begin_block(&mut self, index: usize) {
        self.block = index;
        self.target = self.position;
        self.words.fill(None);
        self.parameters = [None; 3];
        self.own_feed = None;
        self.components = Components::default();
        self.centre_in_vector = false;
        self.addressed = false;
        self.parametric = false;
        self.unread = false;
        self.lost_at_start = self.lost;
        self.motionless = false;
        self.preload = false;
        self.dwells = false;
        self.pause = None;
    }

    pub(crate) fn take_preparatory(&mut self, code: u8) {
        let Preparatory::Assigned(group, _) = preparatory(code) else {
            self.take_declared(code);
            return;
        };
        match (group, code) {
            (Group::Motion, _) => {
                let motion = match code {
                    0 => Motion::Rapid,
                    2 | 3 => Motion::Circle { clockwise: code == 2 },
                    6 => Motion::Parabola,
                    33..=35 => Motion::Thread { constant: code == 33 },
                    _ => Motion::Line,
                };
                self.set_motion(motion);
            }
            (Group::Plane, _) => {
                let plane = match code {
                    17 => Plane::Xy,
                    18 => Plane::Zx,
                    _ => Plane::Yz,
                };
                if self.plane != plane {
                    self.finish_span();
                }
                self.plane = plane;
            }
            (Group::Dimensions, _) => self.incremental = code == 91,
            (Group::Feed, _) => self.set_feed_kind(code),
            (Group::Spindle, _) => {
                // Under constant cutting speed the revolutions hang on the diameter, which no tape says.
                self.cutting_speed = code == 96;
                self.speed = None;
            }
            (Group::Compensation, _) => {
                self.compensation.side = match code {
                    41 => Side::Left,
                    42 => Side::Right,
                    _ => Side::Cancelled,
                };
                if code != 40 && !self.control.compensates() {
                    self.note(EventKind::NotCarriedOut(code));
                }
            }
            (Group::Once, 4) => {
                self.motionless = true;
                self.dwells = self.control.format.itemized.dwell.is_some();
            }
            (Group::Once, 92) => self.preload = true,
            _ => {}
        }
        let dwells = code == 4 && self.dwells;
        if !(dwells || is_carried_out(group, code)) {
            self.note(EventKind::NotCarriedOut(code));
        }
    }

    fn set_motion(&mut self, motion: Motion) {
        if self.motion != Some(motion) {
            self.finish_span();
        }
        self.motion = Some(motion);
    }

    /// G93 to G95. An F word of another kind of feed says nothing of the new one: it must be given again.
    fn set_feed_kind(&mut self, code: u8) {
        let before = (self.coding, self.unit);
        self.coding = match (code, self.control.feed) {
            (93, _) => FeedCoding::TimeReciprocal,
            (_, FeedCoding::TimeReciprocal) => FeedCoding::Direct,
            (_, coding) => coding,
        };
        self.unit = if code == 95 { FeedUnit::PerRevolution } else { FeedUnit::PerMinute };
        if before != (self.coding, self.unit) {
            self.feed = Feed::None;
        }
    }

    /// A function that only the itemized data gives a meaning.
    fn take_declared(&mut self, code: u8) {
        if self.control.is_curve(code) {
            self.set_motion(Motion::Curve { code });
            return;
        }
        let stated = &self.control.format.itemized;
        let name = format!("G{code:02}");
        if stated.declared.as_ref().is_none_or(|declared| !declared.g.contains_key(&name)) {
            self.lost_function = true;
            return;
        }
        self.note(EventKind::NotCarriedOut(code));
    }

    pub(crate) fn take_feed(&mut self, place: usize, word: &Word) {
        // One that lacks digits is at fault, and its number is a guess.
        let whole = self.control.designation(b'F').is_some_and(|it| u16::from(it.width()) == word.digits);
        self.own_feed = Some((place, word.value.filter(|_| whole)));
        let (feed, fault) = feed::read_feed(word, self.control, self.coding, self.unit);
        self.feed = feed;
        self.note_code(place, fault);
        if let Feed::PerMinute(feed) = self.feed {
            self.note_speed(Some(place), feed);
        }
    }

    pub(crate) fn take_speed(&mut self, place: usize, word: &Word) {
        self.any_speed = true;
        let (speed, fault) = feed::read_speed(word, self.control);
        self.speed = speed.filter(|_| !self.cutting_speed);
        self.note_code(place, fault);
    }

    /// Notes where the spindle is started without a speed, on a control whose format has a word for it.
    pub(crate) fn take_miscellaneous(&mut self, place: usize, word: &Word) {
        let starts = matches!(word.function(b'M'), Some(3 | 4 | 13 | 14)) && word.digits == 2;
        if starts && !self.any_speed && self.control.designation(b'S').is_some() {
            self.note(EventKind::SpindleWithoutSpeed { word: place });
        }
    }

    fn note_code(&mut self, word: usize, fault: Option<CodeFault>) {
        match fault {
            Some(CodeFault::Unlisted) => self.note(EventKind::Unlisted { word }),
            Some(CodeFault::SecondDigitZero) => self.note(EventKind::SecondDigitZero { word }),
            Some(CodeFault::Rapid) => self.note(EventKind::RapidSpeed { word }),
            None => {}
        }
    }

    /// Notes a feed above the greatest one of the machine.
    pub(crate) fn note_speed(&mut self, word: Option<usize>, feed: f64) {
        if self.control.format.itemized.maximum_feed.is_some_and(|most| feed > most.0) {
            self.note(EventKind::TooFast { word, feed });
        }
    }

    /// The F word in force is a code of the geometric progression.
    pub(crate) fn is_geometric(&self) -> bool {
        self.coding == FeedCoding::Geometric
    }

    /// Takes a dimension word or an interpolation parameter; any other word is no concern of the path.
    pub(crate) fn take_dimension(&mut self, place: usize, word: &Word) {
        let parameter = b"IJK".iter().position(|&letter| letter == word.address);
        let axis = self.control.axis(word.address);
        // A word that the detail lacks has no place for its decimal sign: it says no number of millimetres.
        self.parametric |= parameter.is_some();
        self.addressed |= axis.is_some();
        let component = word.address.checked_sub(b'P').map(usize::from).filter(|component| *component < 3);
        let designated = self.control.designation(word.address).is_some_and(|designation| designation.dimension);
        let Some(value) = word.value.filter(|_| designated) else {
            self.unread |= parameter.is_some() || axis.is_some();
            self.lost |= axis.map_or(0, bit);
            self.components.unread |= component.is_some();
            return;
        };
        if let Some(index) = parameter {
            self.parameters[index] = Some(Parameter { place, value });
            return;
        }
        if let Some(component) = component {
            self.components.given[component] = Some(Parameter { place, value });
        }
        let Some(axis) = axis else { return };
        // G92 loads the register with the value itself, whatever the dimensions.
        let relative = self.is_incremental(axis) && !self.preload;
        if !relative {
            self.lost &= !bit(axis);
        }
        let target = if relative { self.position[axis].checked_add(value) } else { Some(value) };
        match target {
            Some(target) => {
                self.target[axis] = target;
                self.words[axis] = Some(place);
            }
            None => self.note(EventKind::Overflow { word: place }),
        }
    }

    /// What the block does along these axes is a guess: a word of it, or one before it on which an absolute dimension
    /// rests, could not be read and was reported. That the span then does not fit follows from it.
    pub(crate) fn is_doubtful(&self, axes: impl IntoIterator<Item = usize>) -> bool {
        let lost = |axis: usize| self.lost_at_start & bit(axis) != 0 && !self.is_incremental(axis);
        self.unread || axes.into_iter().any(lost)
    }

    /// The position of an axis is a guess.
    pub(crate) fn is_lost(&self, axis: usize) -> bool {
        self.lost & bit(axis) != 0
    }

    /// How the dimension words of an axis are read at present.
    pub(crate) fn is_incremental(&self, axis: usize) -> bool {
        match self.control.axes[axis].sign {
            _ if self.control.standard() == Standard::Rs274 => self.incremental,
            Some(Sign::Incremental) => true,
            Some(Sign::Both) => self.incremental,
            _ => false,
        }
    }

    /// The block moves no tool: a dwell, or a preload of registers, which sets the position.
    pub(crate) fn is_motionless(&mut self) -> bool {
        if self.preload {
            self.finish_span();
            self.position = self.target;
        }
        self.motionless || self.preload
    }

    /// The least input increment of an axis in the unit of the format.
    pub(crate) fn increment(&self, axis: usize) -> f64 {
        1.0 / power_of_ten(self.control.axes[axis].decimals) as f64
    }

    /// A position of one axis in the unit of the format: one exact division.
    pub(crate) fn in_unit(&self, axis: usize, increments: i64) -> f64 {
        in_unit(&self.control.axes[axis], increments)
    }

    /// X, Y and Z of a position in the unit of the format.
    pub(crate) fn point(&self, position: &[i64]) -> [f64; 3] {
        std::array::from_fn(|axis| self.in_unit(axis, position[axis]))
    }
}

/// A position of an axis in the unit of the format.
pub(crate) fn in_unit(axis: &Axis, increments: i64) -> f64 {
    increments as f64 / power_of_ten(axis.decimals) as f64
}

/// The bit of an axis in a set of axes.
pub(super) fn bit(axis: usize) -> u32 {
    1_u32.checked_shl(axis as u32).unwrap_or(0)
}
