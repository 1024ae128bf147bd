//! From records to spans: what a file says one after the other, carried out.

use super::element::Element;
use super::event::{Event, Noted, Uninterpreted};
use super::record::{Record, Tables};
use super::step::{Act, Step};
use super::words::{Dialect, Key};
use crate::format::Unit;
use crate::span::Spans;

/// What carrying out a text gives.
#[derive(Clone, Debug)]
pub(crate) struct Execution {
    pub spans: Spans,
    pub events: Vec<Noted>,
    pub unit: Unit,
    /// The element with which the end point of each span begins.
    pub ends: Vec<u32>,
    /// The records that are kept and not made anything of, in order; a few of them twice.
    pub kept: Vec<u32>,
    /// What a file has said before some of its records, so that what holds at any record is soon found.
    pub(super) marks: Vec<(usize, File)>,
    /// Nothing where no steps are wanted.
    pub steps: Vec<Step>,
    /// The greatest tolerance that is stated, in the unit of the report.
    pub tolerance: f64,
}

/// What a feed is said per.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Per {
    Minute,
    Revolution,
    /// Something of which the path says nothing: a tooth, the reciprocal of time.
    Other,
}

/// The circle of a surface record that waits for its tool positions, in the unit of the report.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circle {
    pub record: usize,
    pub centre: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
}

/// What a file has said so far.
#[derive(Clone, Debug)]
pub(super) struct File {
    pub position: Option<[f64; 3]>,
    /// 3, or 6 with the tool axis (MULTAX).
    pub point_size: usize,
    pub cut: bool,
    /// The RAPID that waits for a motion.
    pub rapid: Option<usize>,
    pub feed: Option<f64>,
    pub per: Per,
    pub speed: Option<f64>,
    pub turning: bool,
    /// The word of the way that the spindle turns.
    pub way: Option<Key>,
    /// The number of the tool, and the word of the coolant.
    pub tool: Option<f64>,
    pub coolant: Option<Key>,
    /// Of the last position, where positions have one.
    pub tool_axis: Option<[f64; 3]>,
    pub cycle: bool,
    pub cutter: Option<f64>,
    /// What is stated of INTOL and OUTTOL.
    pub tolerance: f64,
    /// One unit of the file in units of the report.
    pub scale: f64,
    pub unit: Option<i64>,
    pub circle: Option<Circle>,
    /// The last record of the last motion: continuations up to here belong to it.
    pub continued: usize,
    pub ended: bool,
    pub moved: bool,
    /// There was a command that MACHIN has to stand before.
    pub commanded: bool,
    /// Whether the file has a SPINDL at all.
    pub spindle_is_told: bool,
    /// The first motion without a feed, and how many; likewise with the spindle off.
    pub without_feed: Option<(usize, usize)>,
    pub spindle_off: Option<(usize, usize)>,
}

impl Default for File {
    fn default() -> File {
        File {
            position: None,
            point_size: 3,
            cut: true,
            rapid: None,
            feed: None,
            per: Per::Minute,
            speed: None,
            turning: false,
            way: None,
            tool: None,
            coolant: None,
            tool_axis: None,
            cycle: false,
            cutter: None,
            tolerance: 0.0,
            scale: 1.0,
            unit: None,
            circle: None,
            continued: 0,
            ended: false,
            moved: false,
            commanded: false,
            spindle_is_told: false,
            without_feed: None,
            spindle_off: None,
        }
    }
}

pub(super) struct State<'a> {
    pub tables: &'a Tables,
    pub dialect: Option<Dialect>,
    pub spans: Spans,
    pub events: Vec<Noted>,
    pub unit: Unit,
    pub file: File,
    /// What is not interpreted, and was said already.
    pub told: Vec<Uninterpreted>,
    pub ends: Vec<u32>,
    pub kept: Vec<u32>,
    /// Steps are wanted.
    pub keeps: bool,
    pub steps: Vec<Step>,
    pub tolerance: f64,
}

/// So many records lie between two marks: what holds at a record is found by carrying out as many at most, which takes
/// some microseconds, and marks take a hundredth of the room of the records.
const BETWEEN_MARKS: usize = 256;

/// Millimetres of the units by their codes under 9000,9 (APT4 SSV3): millimetre, centimetre, inch, foot.
pub(super) fn millimetres(code: i64) -> Option<f64> {
    match code {
        1 => Some(1.0),
        2 => Some(10.0),
        3 => Some(25.4),
        4 => Some(304.8),
        _ => None,
    }
}

/// Carries out all files of a text; keeps every step where that is wanted.
pub(crate) fn execute(tables: &Tables, dialect: Option<Dialect>, keeps: bool) -> Execution {
    let mut state = State { keeps, ..State::new(tables, dialect) };
    let mut marks = Vec::new();
    let first_unit = tables.records.iter().enumerate().find_map(|(index, _)| state.unit_code(index));
    let is_inch = matches!(first_unit, Some(3 | 4));
    state.unit = if is_inch { Unit::Inch } else { Unit::Millimetre };
    for records in tables.file_records() {
        // Before the unit is said it is that of the file, as nobody changes the unit midway.
        let code = records.clone().find_map(|index| state.unit_code(index));
        state.file = File { scale: state.scale_of(code.unwrap_or(if is_inch { 3 } else { 1 })), ..File::default() };
        for index in records.clone() {
            if (index - records.start) % BETWEEN_MARKS == 0 {
                marks.push((index, state.file.clone()));
            }
            let record = tables.records[index];
            state.check_shape(index, &record);
            state.step(index, &record);
        }
        state.end_file(records.end - 1);
    }
    let State { spans, events, unit, ends, kept, steps, tolerance, .. } = state;
    Execution { spans, events, unit, ends, kept, marks, steps, tolerance }
}

impl Execution {
    /// What a file has said when a record has been carried out.
    pub(super) fn behind(&self, record: usize, tables: &Tables, dialect: Option<Dialect>) -> Option<File> {
        let mark = self.marks.partition_point(|mark| mark.0 <= record).checked_sub(1)?;
        let (from, file) = &self.marks[mark];
        let mut state = State { unit: self.unit, file: file.clone(), ..State::new(tables, dialect) };
        for (index, record) in tables.records.iter().enumerate().take(record + 1).skip(*from) {
            state.step(index, record);
        }
        Some(state.file)
    }
}

impl<'a> State<'a> {
    fn new(tables: &'a Tables, dialect: Option<Dialect>) -> State<'a> {
        State {
            tables,
            dialect,
            spans: Spans::new(3, false),
            events: Vec::new(),
            unit: Unit::Millimetre,
            file: File::default(),
            told: Vec::new(),
            ends: Vec::new(),
            kept: Vec::new(),
            keeps: false,
            steps: Vec::new(),
            tolerance: 0.0,
        }
    }
}

impl State<'_> {
    pub(super) fn note(&mut self, event: Event, record: usize, element: Option<usize>) {
        self.events.push(Noted { event, record, element });
    }

    pub(super) fn not_interpreted(&mut self, what: Uninterpreted, record: usize, element: Option<usize>) {
        self.kept.push(record as u32);
        if !self.told.contains(&what) {
            self.told.push(what);
            self.note(Event::NotInterpreted(what), record, element);
        }
    }

    /// The unit of the report in a unit of the file.
    pub(super) fn scale_of(&self, code: i64) -> f64 {
        match (self.unit, code) {
            // A foot divided by an inch is no whole number in an f64.
            (Unit::Inch, 4) => 12.0,
            (Unit::Inch, code) => millimetres(code).unwrap_or(25.4) / 25.4,
            (Unit::Millimetre, code) => millimetres(code).unwrap_or(1.0),
        }
    }

    /// The code of the unit that a record says, if it says one.
    pub(super) fn unit_code(&self, index: usize) -> Option<i64> {
        let record = &self.tables.records[index];
        let elements = self.tables.of(record);
        match record.kind {
            9000 if elements.get(2).and_then(Element::whole) == Some(9) => elements.get(3).and_then(Element::whole),
            20000 if elements.get(3).and_then(Element::key) == Some(Key::of("UNITS")) => {
                let units = ["MM", "CM", "INCHES", "FEET"].map(Key::of);
                let word = elements.get(4).and_then(Element::key)?;
                units.iter().position(|unit| *unit == word).map(|place| place as i64 + 1)
            }
            _ => None,
        }
    }

    fn step(&mut self, index: usize, record: &Record) {
        match record.kind {
            2000 | 20000 => self.command(index, record),
            3000 => self.surface(index, record),
            5000 => self.position(index, record),
            6000 => self.information(record),
            9000 => self.parameter(index, record),
            // What they say of the tape is not public (15000, 21000), or not known at all.
            1000 | 4000 | 7000 | 8000 | 14000 | 16000 | 28000..=32000 => {}
            _ => self.keep(index, |_| Act::Unread),
        }
        if let Some(code) = self.unit_code(index) {
            self.set_unit(code, index);
        }
    }

    fn set_unit(&mut self, code: i64, index: usize) {
        if millimetres(code).is_none() {
            self.note(Event::UnlistedSubtype, index, Some(self.tables.records[index].first as usize + 3));
            return;
        }
        if self.file.moved || self.file.unit.is_some_and(|unit| unit != code) {
            self.note(Event::ChangedUnit, index, None);
        }
        self.file.unit = Some(code);
        self.file.scale = self.scale_of(code);
    }

    /// 6000: the cut flag, tolerances and the cutter.
    fn information(&mut self, record: &Record) {
        let elements = self.tables.of(record);
        let value = |place: usize| elements.get(place).and_then(Element::value);
        match elements.get(2).and_then(Element::whole) {
            Some(1) => self.file.cut = value(3) != Some(1.0),
            Some(3..=5) => {
                let stated = elements[3..].iter().filter_map(Element::value).fold(0.0, f64::max) * self.file.scale;
                self.file.tolerance = self.file.tolerance.max(stated);
                self.tolerance = self.tolerance.max(stated);
            }
            Some(6) => self.file.cutter = value(3).map(|diameter| diameter * self.file.scale),
            _ => {}
        }
    }

    /// 9000,2: whether points have a tool axis; 9000,10: the axis of those that have none.
    fn parameter(&mut self, index: usize, record: &Record) {
        let elements = self.tables.of(record);
        if elements.get(2).and_then(Element::whole) == Some(2) {
            match elements.get(3).and_then(Element::whole) {
                Some(0) => self.file.point_size = 3,
                Some(1) => self.file.point_size = 6,
                _ => {}
            }
        }
        if elements.get(2).and_then(Element::whole) == Some(10) {
            let value = |place: usize| elements.get(place).and_then(Element::value);
            match (value(3), value(4), value(5)) {
                (Some(i), Some(j), Some(k)) => self.keep(index, |_| Act::ToolAxis([i, j, k])),
                _ => self.keep(index, |_| Act::Unread),
            }
        }
    }

    fn end_file(&mut self, last: usize) {
        if let Some(record) = self.file.rapid {
            self.note(Event::IdleRapid, record, None);
        }
        if let Some(circle) = self.file.circle {
            self.note(Event::IdleSurface, circle.record, None);
        }
        if let Some((record, count)) = self.file.without_feed {
            self.note(Event::NoFeed { count }, record, None);
        }
        if let Some((record, count)) = self.file.spindle_off.filter(|_| self.file.spindle_is_told) {
            self.note(Event::SpindleOff { count }, record, None);
        }
        if self.file.moved && !self.file.ended {
            self.note(Event::NoEnd, last, None);
        }
    }
}
