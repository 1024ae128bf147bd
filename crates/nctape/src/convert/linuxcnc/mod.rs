//! RS274/NGC as LinuxCNC reads it.
//!
//! Every executed block gives its functions that act with a motion, its motion, and its functions that act after it, on
//! lines of their own. Coordinates are absolute (G90) and centres relative to the start (G91.1), as they come from the
//! spans. The path is exact (G61): a control for tape rounds no corner, LinuxCNC by itself does.

mod findings;
mod functions;
mod head;
mod motion;
mod words;

pub(crate) use words::comment_lines;

use super::Converted;
use super::comments::comments;
use super::output::Output;
use crate::execute::{self, Follow, Followed as Step};
use crate::format::Plane;
use crate::read::{ProgramMark, Word};
use crate::tape::Tape;
use findings::{Findings, LeftOut};
use functions::Fate;
use motion::Refusal;
use std::iter::Peekable;
use std::ops::Range;
use words::{Lines, plain};

/// LinuxCNC's axes.
fn is_axis(letter: char) -> bool {
    "XYZABCUVW".contains(letter)
}

/// Greatest line number of RS274/NGC.
const MOST_SEQUENCE: i64 = 99_999;

/// Writes a tape for LinuxCNC.
pub(super) fn write(tape: &Tape) -> Converted {
    let mut writer = Writer::new(tape);
    writer.blocks();
    writer.finish()
}

/// What LinuxCNC holds, as far as the text has said so: none of it where a line that says it may be skipped.
#[derive(Default)]
struct InForce {
    plane: Option<Plane>,
    feed_mode: Option<u8>,
    feed: Option<String>,
}

struct Writer<'a> {
    tape: &'a Tape,
    follow: Follow<'a>,
    output: Output,
    findings: Findings,
    in_force: InForce,
    /// The interpolation in force is positioning.
    rapid: Option<bool>,
    /// S is a cutting speed: G96.
    cutting_speed: bool,
    /// A motion of the block has no known feed.
    no_feed: bool,
    /// Chords that were written, and the spans that they stand for with how many.
    chords: usize,
    chorded: Vec<(usize, usize)>,
    /// Registers were preloaded: LinuxCNC would keep that for the next program.
    preloaded: bool,
    /// The last executed block.
    last: Option<usize>,
    /// The program starts that no stretch of the tape has come to yet.
    programs: Peekable<std::vec::IntoIter<ProgramMark>>,
}

impl<'a> Writer<'a> {
    fn new(tape: &'a Tape) -> Writer<'a> {
        let mut last = None;
        let mut follow = Follow::new(tape);
        while let Some(step) = follow.step() {
            last = if step.fate == execute::Fate::Executed { Some(step.index) } else { last };
        }
        Writer {
            tape,
            follow: Follow::new(tape),
            output: Output::default(),
            findings: Findings::default(),
            in_force: InForce { plane: Some(Plane::Xy), feed_mode: Some(94), feed: None },
            rapid: None,
            cutting_speed: false,
            no_feed: false,
            chords: 0,
            chorded: Vec::new(),
            preloaded: false,
            last,
            programs: tape.reading().programs().collect::<Vec<_>>().into_iter().peekable(),
        }
    }

    fn blocks(&mut self) {
        let mut behind = 0;
        while let Some(step) = self.follow.step() {
            self.remarks(behind..step.block.range.start, step.index);
            behind = step.block.range.end;
            match step.fate {
                execute::Fate::Executed => self.block(&step),
                execute::Fate::Skipped => {}
                execute::Fate::Unreached => self.findings.unreached(self.tape, step.index),
            }
        }
        self.remarks(behind..self.tape.text().len(), usize::MAX);
        self.findings.skips(self.tape);
    }

    /// Comments of a stretch of the tape, and the number of a program that begins there.
    fn remarks(&mut self, stretch: Range<usize>, before: usize) {
        if stretch.is_empty() {
            return;
        }
        while self.programs.next_if(|mark| mark.range.start < stretch.start).is_some() {}
        let mark = self.programs.next_if(|mark| stretch.contains(&mark.range.start));
        if let Some(mark) = mark.filter(|mark| !mark.number.is_empty() && before != usize::MAX) {
            let number = self.tape.text()[mark.number].replace(' ', "");
            self.output.comment(&format!("Program {number}"));
        }
        for comment in comments(self.tape.text(), stretch) {
            self.output.comment(&comment);
        }
    }

    fn block(&mut self, step: &Step<'_>) {
        let source = step.block.range.clone();
        let sequence = step.block.sequence_number().filter(|number| (0..=MOST_SEQUENCE).contains(number));
        let sequence = sequence.and_then(|_| self.tape.sequence(step.block)).map(|text| text[1..].to_owned());
        self.output.begin(step.block.skip, sequence);
        if step.block.skip {
            self.in_force = InForce::default();
        }
        for comment in comments(self.tape.text(), source.clone()) {
            self.output.comment(&comment);
        }
        self.modes(step);
        let (before, after) = self.functions(step);
        before.lines.iter().for_each(|line| self.output.line(line));
        self.preload(step);
        self.motions(step);
        after.lines.iter().for_each(|line| self.output.line(line));
        self.end_of_program(step);
        if step.block.skip {
            self.in_force = InForce::default();
        }
        let lines = self.output.end(source);
        let firsts = step.spans.clone().map(|span| self.tape.spans().list[span].blocks.0);
        for first in firsts.filter(|first| *first != step.index) {
            self.output.link(self.tape.reading().blocks[first].range.clone(), lines.clone());
        }
    }

    /// What the preparatory functions of the block say of its motion.
    fn modes(&mut self, step: &Step<'_>) {
        for word in step.words {
            match word.function(b'G') {
                Some(code @ (0..=3 | 6 | 33..=35)) => self.rapid = Some(code == 0),
                Some(code @ (96 | 97)) => self.cutting_speed = code == 96,
                _ => {}
            }
        }
    }

    /// The functions of the block before and behind its motion.
    fn functions(&mut self, step: &Step<'_>) -> (Lines, Lines) {
        let (mut before, mut after) = (Lines::default(), Lines::default());
        // A tool is chosen before it is changed to, and a speed before the spindle is started, wherever they stand.
        for word in step.words.iter().filter(|word| word.address == b'T') {
            match self.tool(word) {
                Some(tool) => before.add(functions::TOOL + 16, &tool),
                None => self.leave_out(step, word, LeftOut::Word(b'T')),
            }
        }
        for word in step.words.iter().filter(|word| word.address == b'M') {
            let Some(code) = word.function(b'M') else {
                self.leave_out(step, word, LeftOut::Word(b'M'));
                continue;
            };
            for fate in functions::miscellaneous(code) {
                match *fate {
                    Fate::Before(group, words) if group == functions::TOOL => before.add(group, words),
                    Fate::After(group, words) => after.add(group, words),
                    Fate::Partly(group, words) => {
                        after.add(group, words);
                        self.leave_out(step, word, LeftOut::Miscellaneous(code));
                    }
                    Fate::LeftOut => self.leave_out(step, word, LeftOut::Miscellaneous(code)),
                    Fate::Absorbed | Fate::Before(..) | Fate::End(_) => {}
                }
            }
        }
        let dwell = self.tape.control().format.itemized.dwell.as_ref().filter(|_| is_dwell(step));
        let dwell = dwell.map(|dwell| dwell.address);
        for word in step.words {
            match word.address {
                _ if dwell == Some(word.letter()) => {}
                b'S' => match self.follow.spindle_number(word).map(plain) {
                    Some(speed) if self.cutting_speed => before.add(functions::SPEED, &format!("G96 S{speed}")),
                    Some(speed) => before.add(functions::SPEED, &format!("S{speed}")),
                    None => self.leave_out(step, word, LeftOut::Word(b'S')),
                },
                b'G' => self.preparatory(step, word, &mut before),
                b'N' | b':' | b'F' | b'T' | b'M' | b'I' | b'J' | b'K' => {}
                address => {
                    let axis = self.tape.control().axis(address).is_some() && is_axis(char::from(address));
                    if !axis {
                        self.leave_out(step, word, LeftOut::Word(address));
                    }
                }
            }
        }
        let starts = step.words.iter().filter_map(|word| word.function(b'M')).flat_map(functions::miscellaneous);
        for fate in starts {
            if let Fate::Before(group, words) = *fate
                && group != functions::TOOL
            {
                before.add(group, words);
            }
        }
        (before, after)
    }

    fn preparatory(&mut self, step: &Step<'_>, word: &Word, before: &mut Lines) {
        match word.function(b'G') {
            Some(97) => before.add(functions::SPEED, "G97"),
            Some(code) if functions::preparatory(code) == Fate::LeftOut && !self.is_curve(code) => {
                self.leave_out(step, word, LeftOut::Preparatory(code));
            }
            Some(_) => {}
            None => self.leave_out(step, word, LeftOut::Word(b'G')),
        }
    }

    /// The itemized data declares the code as a curve.
    fn is_curve(&self, code: u8) -> bool {
        let curves = self.tape.control().format.itemized.curves.as_ref();
        curves.is_some_and(|curves| curves.contains_key(&format!("G{code:02}")))
    }

    /// The tool of a T word, the digits of the compensation left aside.
    fn tool(&mut self, word: &Word) -> Option<String> {
        let digits = self.tape.control().format.itemized.compensation_digits.unwrap_or(0);
        let scale = 10_i64.checked_pow(u32::from(digits))?;
        word.value.map(|value| format!("T{}", value / scale))
    }

    fn leave_out(&mut self, step: &Step<'_>, word: &Word, what: LeftOut) {
        let range = self.tape.reading().range(step.block, word);
        let sentence = what.sentence(self.tape.control(), &self.tape.text()[range.clone()]);
        self.output.comment(&format!("LEFT OUT: {sentence}"));
        self.findings.left_out(what, range);
    }

    /// G92 loads the registers: it means the same to LinuxCNC.
    fn preload(&mut self, step: &Step<'_>) {
        if !step.words.iter().any(|word| word.function(b'G') == Some(92)) {
            return;
        }
        let axes = 0..self.tape.control().axes.len();
        let named = axes.filter(|&axis| self.follow.addressed(axis));
        let words: Vec<_> = named.filter_map(|axis| self.axis(axis, 0.0, self.follow.target(axis))).collect();
        self.preloaded |= !words.is_empty();
        self.straight("G92", &words, None);
    }

    fn motions(&mut self, step: &Step<'_>) {
        self.no_feed = false;
        for span in step.spans.clone() {
            if let Err(refusal) = self.span(span) {
                self.refuse(step, span, refusal);
            }
        }
        let preloads = step.words.iter().any(|word| word.function(b'G') == Some(92));
        if is_dwell(step) {
            self.dwell(step);
        } else if step.spans.is_empty() && !preloads && !self.follow.waits() {
            self.standstill();
        }
        if self.no_feed {
            self.findings.no_feed(self.extent(step.index));
        }
    }

    /// A block that names axes where they stand already. That it stands there the tape may only assume: an absolute tape
    /// begins so.
    fn standstill(&mut self) {
        let axes = 0..self.tape.control().axes.len();
        let named = axes.filter(|&axis| self.follow.addressed(axis));
        let ends: Vec<_> =
            named.filter_map(|axis| self.axis(axis, self.follow.target(axis), self.follow.target(axis))).collect();
        match self.rapid {
            _ if ends.is_empty() => {}
            Some(true) => self.straight("G0", &ends, None),
            Some(false) if !self.follow.is_thread() => {
                let feed = self.feed_in_force();
                if feed != motion::Feed::Unknown {
                    self.straight("G1", &ends, Some(feed));
                }
            }
            _ => {}
        }
    }

    fn dwell(&mut self, step: &Step<'_>) {
        match self.follow.dwell() {
            Some(seconds) => self.output.line(&format!("G4 P{}", plain(seconds))),
            None => {
                if let Some(word) = step.words.iter().find(|word| word.function(b'G') == Some(4)) {
                    self.leave_out(step, word, LeftOut::Preparatory(4));
                }
            }
        }
    }

    /// Says that a span is not written, and makes LinuxCNC stop there.
    fn refuse(&mut self, step: &Step<'_>, span: usize, refusal: Refusal) {
        let blocks = self.tape.spans().list[span].blocks;
        let range = self.extent(blocks.0).start..self.extent(blocks.1).end;
        let line = 1 + self.tape.text()[..range.start].matches('\n').count();
        let name = self.tape.sequence(&self.tape.reading().blocks[blocks.0]);
        let name = name.unwrap_or_else(|| format!("the block in line {line}"));
        self.output.comment(&format!("NOT CONVERTED: {name}"));
        self.output.line(&format!("(ABORT,{name} of the tape is not converted)"));
        self.findings.refused(range, refusal);
        // Where the tool stands is known again at the end of the span only to the tape.
        debug_assert!(blocks.1 <= step.index);
    }

    /// The end of program, or a stop where other programs follow.
    fn end_of_program(&mut self, step: &Step<'_>) {
        let ends = step.words.iter().filter_map(|word| word.function(b'M')).flat_map(functions::miscellaneous);
        let Some(end) = ends.filter_map(|fate| if let Fate::End(end) = fate { Some(*end) } else { None }).next() else {
            return;
        };
        if self.last != Some(step.index) {
            self.output.comment(&format!("{end} on the tape: another program follows"));
            self.output.line("M5 M9 M0");
            self.findings.intermediate_end(self.extent(step.index));
            return;
        }
        if self.preloaded {
            self.output.line("G92.1");
        }
        self.output.line(end);
    }

    /// From the first to the last word of a block.
    fn extent(&self, index: usize) -> Range<usize> {
        self.tape.view().extent(index)
    }

    fn finish(mut self) -> Converted {
        self.findings.chords(self.tape, &self.chorded, self.chord_tolerance());
        let head = head::write(self.tape, &self.findings, self.chord_tolerance(), !self.chorded.is_empty());
        let by = head.len();
        let shift = |range: Range<usize>| range.start + by..range.end + by;
        Converted {
            text: head + &self.output.text + "%\n",
            diagnostics: self.findings.told(self.tape),
            map: self.output.map.into_iter().map(|(source, text)| (source, shift(text))).collect(),
        }
    }
}

fn is_dwell(step: &Step<'_>) -> bool {
    step.words.iter().any(|word| word.function(b'G') == Some(4))
}
