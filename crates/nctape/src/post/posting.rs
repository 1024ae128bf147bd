//! Walks over the steps of every file and writes their blocks.

use super::cycle::{Cycle, CycleState};
use super::machine::Machine;
use super::source::Source;
use super::{Arcs, Options};
use crate::cldata::step::{Act, Step};
use crate::convert::Converted;
use crate::diagnostic::{Diagnostic, Severity, Sink};
use crate::format::{Control, Unit};
use crate::rules::Rule;
use crate::rules::{conversion, posting as rules};
use crate::write::{Fault, Numbering, TapeWriter};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// Writes the tape of a text.
pub(super) struct Poster<'a> {
    pub source: &'a Source,
    pub control: &'a Control,
    pub arcs: Arcs,
    /// How far an arc may be off, in the unit of the format.
    pub tolerance: f64,
    pub writer: TapeWriter<'a>,
    /// A unit of the text in units of the format: by what a length is multiplied and divided, as 1 / 25,4 is no number
    /// that an f64 holds.
    unit: [f64; 2],
    diagnostics: Vec<Diagnostic>,
    /// Where a finding is that is said once, with its count.
    said: HashMap<(&'static str, String), usize>,
    map: Vec<(Range<usize>, Range<usize>)>,
    /// The first record of which a number was rounded.
    rounded: Option<Range<usize>>,
    /// Where the text ended when the tape was last stopped for what is lacking.
    stopped: Option<usize>,
    /// Straight cuts that arcs became.
    pub chords: usize,
    pub state: State,
}

/// What a file has said so far.
#[derive(Clone, Debug)]
pub(super) struct State {
    /// There was a motion.
    pub begun: bool,
    /// Where the tool is said to stand, and the record that says so.
    pub from: Option<(usize, [f64; 3])>,
    /// Axes that the next motion says, whether they move or not: what was said of them may have been skipped.
    pub unsaid: [bool; 3],
    pub machine: Machine,
    pub cycle: CycleState,
    pub last_cycle: Option<Cycle>,
    /// The axis of points without one of their own.
    pub tool_axis: [f64; 3],
    /// Where the tool stood when optional blocks began.
    pub skip_start: Option<[f64; 3]>,
    /// The plane to which RETRCT goes, in the unit of the format.
    pub clearance: Option<f64>,
    /// The END behind which nothing moves; REWIND.
    pub end: Option<usize>,
    pub rewinds: bool,
}

impl Default for State {
    fn default() -> State {
        State {
            begun: false,
            from: None,
            unsaid: [false; 3],
            machine: Machine::default(),
            cycle: CycleState::Off,
            last_cycle: None,
            tool_axis: [0.0, 0.0, 1.0],
            skip_start: None,
            clearance: None,
            end: None,
            rewinds: false,
        }
    }
}

impl<'a> Poster<'a> {
    pub(super) fn new(source: &'a Source, control: &'a Control, options: &Options, incomplete: bool) -> Poster<'a> {
        let unit = match (source.cldata.unit(), control.unit) {
            (Unit::Inch, Unit::Millimetre) => [25.4, 1.0],
            (Unit::Millimetre, Unit::Inch) => [1.0, 25.4],
            _ => [1.0, 1.0],
        };
        let finest = control.axes.iter().take(3).map(|axis| axis.decimals).min().unwrap_or(0);
        let stated = source.cldata.tolerance() * unit[0] / unit[1];
        let half = 0.5 / crate::format::power_of_ten(finest) as f64;
        let mut wanted = options.tolerance.into_iter().chain([stated]);
        let tolerance = wanted.find(|wanted| wanted.is_finite() && *wanted > 0.0).unwrap_or(half);
        let mut writer = TapeWriter::new(control);
        writer.quadrants = options.quadrants;
        if incomplete {
            writer.comment("INCOMPLETE");
        }
        Poster {
            source,
            control,
            arcs: options.arcs.unwrap_or(Arcs::Circles),
            tolerance,
            writer,
            unit,
            diagnostics: Vec::new(),
            said: HashMap::new(),
            map: Vec::new(),
            rounded: None,
            stopped: None,
            chords: 0,
            state: State::default(),
        }
    }

    pub(super) fn post(mut self) -> Converted {
        let source = self.source;
        for fault in &source.faults {
            self.report(&rules::statement_not_read::RULE, "", fault.range.clone(), fault.message.clone());
        }
        if source.cldata.records().is_empty() {
            let text = String::new();
            return Converted { text, diagnostics: self.diagnostics, map: Vec::new() };
        }
        let steps = source.cldata.steps();
        let mut at = 0;
        for (file, records) in source.cldata.file_records().enumerate() {
            if file > 0 {
                self.writer.program("");
                self.writer.numbering = Numbering::default();
                self.state = State::default();
            }
            let last = records.end.saturating_sub(1);
            for record in records {
                let from = self.writer.text.len();
                while let Some(step) = steps.get(at).filter(|step| step.record == record) {
                    self.step(step, &steps[at + 1..], last);
                    at += 1;
                    // A thousandth of an increment is what decimal fractions lose in binary.
                    if self.rounded.is_none() && self.writer.rounding > 1e-3 {
                        self.rounded = Some(source.record(record));
                    }
                }
                self.map.push((source.record(record), from..self.writer.text.len()));
            }
            self.end_program(last);
        }
        self.finish()
    }

    fn step(&mut self, step: &Step, behind: &[Step], last: usize) {
        match &step.act {
            Act::From(at) => self.state.from = Some((step.record, *at)),
            Act::ToolAxis(axis) => self.state.tool_axis = *axis,
            Act::Motion(motion) => {
                let from = self.writer.text.len();
                self.motion(motion);
                // The record of its circle and those of its points lead to it, too.
                let first = motion.circle.unwrap_or(step.record);
                for record in first..step.record {
                    if matches!(self.source.cldata.records()[record].kind, 3000 | 5000) {
                        self.map.push((self.source.record(record), from..self.writer.text.len()));
                    }
                }
            }
            Act::Command { word, arguments } => {
                let rest = behind.iter().take_while(|step| step.record <= last);
                let moves = rest.into_iter().any(|step| matches!(step.act, Act::Motion(_)));
                self.command(step, *word, arguments, moves);
            }
            Act::Unread => self.unread(step.record),
        }
    }

    /// A record that cannot be read, or of whose type nothing is known.
    fn unread(&mut self, record: usize) {
        let message = match self.source.cldata.records()[record].kind {
            15000 => "What an unsegmented tool path (type 15000) means is not public: have the processor write its \
                      points (type 5000)."
                .to_owned(),
            21000 => "A deferred command (type 21000) is for another processor than this.".to_owned(),
            0 => "This record has no type that can be read.".to_owned(),
            2000 | 20000 => "The word of this command cannot be read.".to_owned(),
            kind => format!("Records of type {kind} are not of ISO 3592: what they do at the machine is not known."),
        };
        self.lack(&rules::command_not_posted::RULE, "", self.source.record(record), message);
    }

    /// The end of the program: M02, or M30 where the tape is rewound.
    fn end_program(&mut self, last: usize) {
        self.writer.skip = false;
        let record = self.state.end.unwrap_or(last);
        let from = self.writer.text.len();
        let written = self.writer.function('M', if self.state.rewinds { 30 } else { 2 });
        if let Err(fault) = written {
            self.report(&conversion::does_not_fit::RULE, "", self.source.record(record), format!("{}.", fault.told()));
        }
        self.map.push((self.source.record(record), from..self.writer.text.len()));
    }

    /// A length of the text in the unit of the format.
    pub(super) fn length(&self, value: f64) -> f64 {
        value * self.unit[0] / self.unit[1]
    }

    pub(super) fn point(&self, point: [f64; 3]) -> [f64; 3] {
        point.map(|value| self.length(value))
    }

    /// Reports a finding; where the same was said before, it counts.
    pub(super) fn report(&mut self, rule: &'static Rule, key: &str, range: Range<usize>, message: String) {
        let key = if key.is_empty() { message.clone() } else { key.to_owned() };
        if let Some(&before) = self.said.get(&(rule.name, key.clone())) {
            self.diagnostics[before].count += 1;
            return;
        }
        let before = self.diagnostics.len();
        Sink::new(self.control.standard(), &mut self.diagnostics).report(rule, range, message);
        if self.diagnostics.len() > before {
            self.said.insert((rule.name, key), before);
        }
    }

    /// The last finding, to be added to.
    pub(super) fn last_finding(&mut self) -> Option<&mut Diagnostic> {
        self.diagnostics.last_mut()
    }

    /// Something is lacking: it is reported, and the tape stops, if its format has a word for that. Where it has just
    /// stopped for something else, once is enough.
    pub(super) fn lack(&mut self, rule: &'static Rule, key: &str, range: Range<usize>, message: String) {
        self.report(rule, key, range, format!("{message} It is left out, and the tape stops there."));
        if self.stopped == Some(self.writer.text.len()) {
            return;
        }
        self.writer.comment("NOT POSTED");
        let _ = self.writer.function('M', 0);
        self.state.machine.stopped();
        self.stopped = Some(self.writer.text.len());
    }

    /// Says why something was not written.
    pub(super) fn take(&mut self, written: Result<(), Fault>, range: Range<usize>) -> bool {
        let Err(fault) = written else { return true };
        self.lack(&conversion::does_not_fit::RULE, "", range, format!("{}.", fault.told()));
        false
    }

    fn finish(mut self) -> Converted {
        self.writer.finish();
        if let Some(range) = self.rounded.take() {
            let message = format!(
                "Numbers are rounded to the places of the format, by up to {:.2} of a least input increment.",
                self.writer.rounding
            );
            self.report(&conversion::rounded::RULE, "", range, message);
        }
        self.diagnostics.sort_by_key(|found| found.range.start);
        self.map.sort_by_key(|(source, text)| (text.start, text.end, source.start));
        // A record that has a part in blocks elsewhere is not one that gave nothing.
        let giving: HashSet<usize> =
            self.map.iter().filter(|(_, text)| !text.is_empty()).map(|(source, _)| source.start).collect();
        self.map.retain(|(source, text)| !text.is_empty() || !giving.contains(&source.start));
        Converted { text: self.writer.text, diagnostics: self.diagnostics, map: self.source.joined(self.map) }
    }
}

impl Converted {
    /// Something of the source is not in the text: a finding is an error.
    pub fn is_incomplete(&self) -> bool {
        self.diagnostics.iter().any(|found| found.severity == Severity::Error)
    }
}
