//! Post-processor commands (types 2000 and 20000), as far as they bear on the path and its time.

use super::element::{Element, ElementKind};
use super::event::{Event, Uninterpreted};
use super::execution::{Per, State};
use super::record::Record;
use super::step::Act;
use super::words::{Dialect, Key, Part, decode};
use crate::format::Unit;

/// What stands behind the word of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Argument {
    Number(f64),
    Word(Key),
    Other,
}

const RAPID: Key = Key::of("RAPID");
const FEDRAT: Key = Key::of("FEDRAT");
const SPINDL: Key = Key::of("SPINDL");
const LOADTL: Key = Key::of("LOADTL");
const TOOLNO: Key = Key::of("TOOLNO");
const TURRET: Key = Key::of("TURRET");
const COOLNT: Key = Key::of("COOLNT");
const CLW: Key = Key::of("CLW");
const CCLW: Key = Key::of("CCLW");
const CUTCOM: Key = Key::of("CUTCOM");
const CYCLE: Key = Key::of("CYCLE");
const MULTAX: Key = Key::of("MULTAX");
const MACHIN: Key = Key::of("MACHIN");
const PARTNO: Key = Key::of("PARTNO");
const PPRINT: Key = Key::of("PPRINT");
const UNITS: Key = Key::of("UNITS");
const END: Key = Key::of("END");
const INDEX: Key = Key::of("INDEX");
const COPY: Key = Key::of("COPY");
const TRACUT: Key = Key::of("TRACUT");
const ORIGIN: Key = Key::of("ORIGIN");
const TRANS: Key = Key::of("TRANS");
const ROTABL: Key = Key::of("ROTABL");
const ROTHED: Key = Key::of("ROTHED");
const INSERT: Key = Key::of("INSERT");
const THREAD: Key = Key::of("THREAD");
const ON: Key = Key::of("ON");
const OFF: Key = Key::of("OFF");
const ORIENT: Key = Key::of("ORIENT");
const SFM: Key = Key::of("SFM");
const SMM: Key = Key::of("SMM");
const MAXRPM: Key = Key::of("MAXRPM");
const RANGE: Key = Key::of("RANGE");
const PERMIN: Key = Key::of("PERMIN");
const PERREV: Key = Key::of("PERREV");
const IPM: Key = Key::of("IPM");
const IPR: Key = Key::of("IPR");
const MMPM: Key = Key::of("MMPM");
const MMPR: Key = Key::of("MMPR");
const FPT: Key = Key::of("FPT");
const INVERS: Key = Key::of("INVERS");
const DEPTH: Key = Key::of("DEPTH");
const FEDTO: Key = Key::of("FEDTO");
const DWELL: Key = Key::of("DWELL");

impl State<'_> {
    /// The word of a command, and what stands behind it.
    fn words(&mut self, index: usize, record: &Record) -> Option<(Key, Vec<Argument>)> {
        let tables = self.tables;
        let elements = tables.of(record);
        if record.kind == 20000 {
            let plain = |element: &Element| match (element.key(), element.value()) {
                (Some(key), _) => Argument::Word(key),
                (None, Some(value)) => Argument::Number(value),
                _ => Argument::Other,
            };
            let key = elements.get(3).and_then(Element::key)?;
            return Some((key, elements.iter().skip(4).map(plain).collect()));
        }
        let first = record.first as usize;
        let key = self.coded(Part::Major, index, first + 2)?;
        let mut arguments = Vec::new();
        for (place, element) in elements.iter().enumerate().skip(3) {
            // Words are integers and numbers are reals.
            arguments.push(match element.kind {
                ElementKind::Integer => {
                    self.coded(Part::Minor, index, first + place).map_or(Argument::Other, Argument::Word)
                }
                ElementKind::Real => element.value().map_or(Argument::Other, Argument::Number),
                _ => Argument::Other,
            });
        }
        Some((key, arguments))
    }

    /// The word of a code; what is doubtful about it is noted.
    fn coded(&mut self, part: Part, record: usize, element: usize) -> Option<Key> {
        let code = self.tables.elements.get(element)?.whole()?;
        let found =
            u16::try_from(code).ok().and_then(|code| decode(part, code, self.dialect.unwrap_or(Dialect::Common)));
        match found {
            None => self.note(Event::UnlistedCode { code }, record, Some(element)),
            Some(coded) => {
                if let Some(other) = coded.other.filter(|_| self.dialect.is_none()) {
                    self.note(Event::SplitCode { word: coded.word, other }, record, Some(element));
                }
            }
        }
        found.map(|coded| coded.word)
    }

    pub(super) fn command(&mut self, index: usize, record: &Record) {
        let Some((word, arguments)) = self.words(index, record) else {
            self.keep(index, |_| Act::Unread);
            return;
        };
        self.keep(index, |_| Act::Command { word, arguments: arguments.clone() });
        let has = |key: Key| arguments.contains(&Argument::Word(key));
        match word {
            RAPID => {
                if let Some(idle) = self.file.rapid.replace(index) {
                    self.note(Event::IdleRapid, idle, None);
                }
            }
            FEDRAT => self.feed(&arguments),
            SPINDL => self.spindle(&arguments),
            LOADTL | TOOLNO | TURRET => {
                if word == LOADTL && self.file.turning {
                    self.note(Event::ToolWithSpindle, index, None);
                }
                self.file.tool = number_of(&arguments).or(self.file.tool);
            }
            COOLNT => {
                let words = arguments.iter().find_map(|argument| match argument {
                    Argument::Word(key) => Some(*key),
                    _ => None,
                });
                self.file.coolant = words.or(self.file.coolant);
            }
            CUTCOM => {
                if self.file.circle.is_some() {
                    self.note(Event::CompensationOnArc, index, None);
                }
                if !has(OFF) {
                    self.not_interpreted(Uninterpreted::Command(word), index, None);
                }
            }
            CYCLE => self.cycle(index, &arguments),
            MULTAX => self.file.point_size = if has(OFF) { 3 } else { 6 },
            END => {
                self.file.ended = true;
                self.file.turning = false;
                self.file.coolant = self.file.coolant.map(|_| OFF);
            }
            MACHIN if self.file.commanded => self.note(Event::LateMachin, index, None),
            INDEX | COPY | TRACUT | ORIGIN | TRANS | ROTABL | ROTHED | INSERT | THREAD => {
                self.not_interpreted(Uninterpreted::Command(word), index, None);
            }
            _ => {}
        }
        self.file.commanded |= !matches!(word, MACHIN | PARTNO | PPRINT | UNITS);
    }

    /// FEDRAT: the value and its unit in either order; what is left out stays.
    fn feed(&mut self, arguments: &[Argument]) {
        // By what a value is multiplied and divided: 1 / 25,4 is no number that an f64 holds.
        let own = [self.file.scale, 1.0];
        let mut factor = own;
        let (inches, millimetres) = match self.unit {
            Unit::Inch => ([1.0, 1.0], [1.0, 25.4]),
            Unit::Millimetre => ([25.4, 1.0], [1.0, 1.0]),
        };
        for argument in arguments {
            let Argument::Word(unit) = *argument else { continue };
            let (per, unit_factor) = match unit {
                PERMIN => (Per::Minute, own),
                PERREV => (Per::Revolution, own),
                IPM => (Per::Minute, inches),
                IPR => (Per::Revolution, inches),
                MMPM => (Per::Minute, millimetres),
                MMPR => (Per::Revolution, millimetres),
                FPT | INVERS => (Per::Other, own),
                _ => continue,
            };
            (self.file.per, factor) = (per, unit_factor);
        }
        let value = number_of(arguments);
        self.file.feed = value.map(|value| value * factor[0] / factor[1]).or(self.file.feed);
    }

    /// SPINDL: the speed, where it is one in revolutions, and whether it turns.
    fn spindle(&mut self, arguments: &[Argument]) {
        self.file.spindle_is_told = true;
        let has = |key: Key| arguments.contains(&Argument::Word(key));
        self.file.turning = !(has(OFF) || has(ORIENT));
        self.file.way = [CLW, CCLW].into_iter().find(|way| has(*way)).or(self.file.way);
        let by_surface = has(SFM) || has(SMM);
        // The value behind MAXRPM and RANGE is another's.
        let mut own = true;
        for argument in arguments {
            match argument {
                Argument::Word(key) => own = !matches!(*key, MAXRPM | RANGE),
                Argument::Number(value) if own => {
                    self.file.speed = (!by_surface).then_some(value.abs());
                    own = false;
                }
                _ => {}
            }
        }
    }

    /// CYCLE: on for every position that follows, until it is off.
    fn cycle(&mut self, index: usize, arguments: &[Argument]) {
        let has = |key: Key| arguments.contains(&Argument::Word(key));
        self.file.cycle = !has(OFF);
        if !self.file.cycle {
            return;
        }
        self.not_interpreted(Uninterpreted::Command(CYCLE), index, None);
        // ON takes up the last one. Older systems write the depth right behind the kind.
        let is_stated = has(DEPTH) || has(FEDTO) || has(DWELL) && arguments.len() == 2;
        let by_place = matches!(arguments.get(1), Some(Argument::Number(_)));
        if !(is_stated || by_place || arguments == [Argument::Word(ON)]) {
            self.note(Event::CycleWithoutDepth, index, None);
        }
    }
}

/// The first number.
fn number_of(arguments: &[Argument]) -> Option<f64> {
    arguments.iter().find_map(|argument| match argument {
        Argument::Number(value) => Some(*value),
        _ => None,
    })
}
