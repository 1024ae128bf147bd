//! A tape as a tape of another format.
//!
//! Every executed block gives the preparatory functions that act by themselves, in blocks of their own because a block
//! has one G, and then its motion with the tool, speed and miscellaneous function of the block: the meaning of a number
//! is that of ISO 1056 on both sides. The path comes from the spans, so that dimensions, readings of I, J and K and
//! codings of feeds are settled before it.

mod functions;
mod motion;

use super::Converted;
use super::comments::comments;
use super::fault::told;
use super::noted::Noted;
use crate::diagnostic::{Diagnostic, Sink};
use crate::execute::{self, Follow, Followed as Step, ends_program, in_unit};
use crate::format::{Angles, Control, Format, Unit};
use crate::read::ProgramMark;
use crate::rules::conversion as rules;
use crate::rules::skip::changes_what_follows;
use crate::tape::Tape;
use crate::write::{Fault, TapeWriter};
use std::ops::Range;

/// Writes a tape for another format.
pub(super) fn write(tape: &Tape, to: &Format) -> Converted {
    let to = Control::new(to);
    let mut writer = Writer::new(tape, &to);
    writer.begin();
    writer.blocks();
    writer.finish()
}

struct Writer<'a> {
    tape: &'a Tape,
    follow: Follow<'a>,
    to: &'a Control,
    out: TapeWriter<'a>,
    map: Vec<(Range<usize>, Range<usize>)>,
    diagnostics: Vec<Diagnostic>,
    noted: Noted,
    /// Units of the other format in one of the tape's: of lengths, and of the angles of rotary axes.
    scale: [f64; 2],
    /// For every axis of the other format, that of the tape.
    axes: Vec<Option<usize>>,
    /// The preparatory function of the thread in force.
    thread: u8,
    /// S is a cutting speed: G96.
    cutting_speed: bool,
    /// The cuts have no known feed, and the tape has stopped before the first of them.
    unfed: bool,
    /// Chords that were written.
    chords: usize,
}

impl<'a> Writer<'a> {
    fn new(tape: &'a Tape, to: &'a Control) -> Writer<'a> {
        let from = tape.control();
        let inches = |control: &Control| if control.unit == Unit::Inch { 25.4 } else { 1.0 };
        let turn = |control: &Control| if control.angles() == Angles::Turns { 1.0 } else { 360.0 };
        let axes = to.axes.iter().map(|axis| from.axes.iter().position(|own| own.letter == axis.letter)).collect();
        Writer {
            tape,
            follow: Follow::new(tape),
            to,
            out: TapeWriter::new(to),
            map: Vec::new(),
            diagnostics: Vec::new(),
            noted: Noted::default(),
            scale: [inches(from) / inches(to), turn(to) / turn(from)],
            axes,
            thread: 33,
            cutting_speed: false,
            unfed: false,
            chords: 0,
        }
    }

    /// A coordinate or a length along an axis, in the unit of the other format. A to E turn (3.2.2.2).
    fn in_other(&self, letter: char, value: f64) -> f64 {
        let scale = self.scale[usize::from(('A'..='E').contains(&letter))];
        // What is in the same unit stays as it is, to the bit.
        if scale == 1.0 { value } else { value * scale }
    }

    /// The tool stands where the tape has it before its first block, whatever the other format states: so no motion is
    /// made up.
    fn begin(&mut self) {
        let from = self.tape.control();
        let at = |(axis, own): (usize, &Option<usize>)| {
            let own = own.filter(|_| self.to.axes[axis].sign.is_some())?;
            let letter = from.axes[own].letter;
            Some(self.in_other(letter, in_unit(&from.axes[own], from.set_point[own])))
        };
        let at: Vec<Option<f64>> = self.axes.iter().enumerate().map(at).collect();
        let before: Vec<f64> = (0..at.len()).map(|axis| self.out.position(axis)).collect();
        if self.out.stand(&at).is_err() || self.tape.reading().blocks.is_empty() {
            return;
        }
        let moved = (0..at.len()).filter(|&axis| self.out.position(axis) != before[axis]);
        let places: Vec<String> =
            moved.map(|axis| format!("{}{}", self.to.axes[axis].letter, self.out.position(axis))).collect();
        if !places.is_empty() {
            let message = format!(
                "Before this block the tool stands at {}, by the format of the tape, and the other format states another \
                 set point. The tape is written for this one: state it there, or go to it before the tape is started.",
                places.join(" ")
            );
            let range = self.tape.view().extent(0);
            self.report(&rules::other_set_point::RULE, range, message);
        }
    }

    fn blocks(&mut self) {
        let marks: Vec<ProgramMark> = self.tape.reading().programs().collect();
        let (mut behind, mut program, mut ended) = (0, None, false);
        while let Some(step) = self.follow.step() {
            if program.replace(step.block.program) != Some(step.block.program) {
                // Behind a program that has not ended a program start character starts no other.
                let mark = marks.iter().rfind(|mark| mark.range.start < step.block.range.end);
                self.program(mark, ended);
                ended = false;
            }
            self.remarks(behind..step.block.range.start);
            behind = step.block.range.end;
            match step.fate {
                execute::Fate::Executed => {
                    self.block(&step);
                    ended |= ends_program(step.words);
                }
                execute::Fate::Skipped => {}
                execute::Fate::Unreached => {
                    let message = "Blocks behind the end of the program are left out: no control executes them.";
                    let range = self.tape.view().extent(step.index);
                    self.report(&rules::unreached_left_out::RULE, range, message.to_owned());
                }
            }
        }
        self.remarks(behind..self.tape.text().len());
        self.skips();
    }

    /// The program start character of another program, and the number behind it.
    fn program(&mut self, mark: Option<&ProgramMark>, ended: bool) {
        let written = mark.map_or("", |mark| &self.tape.text()[mark.number.clone()]);
        let digits: String = written.chars().filter(char::is_ascii_digit).collect();
        let number = match self.to.format.itemized.program_number_digits.map(usize::from) {
            _ if digits.is_empty() => String::new(),
            Some(width) if digits.trim_start_matches('0').len() <= width => {
                format!("{:0>width$}", digits.trim_start_matches('0'))
            }
            _ => {
                let message =
                    "The number of this program is left out: the other format has none, or not so many digits.";
                let range = mark.map_or(0..0, |mark| mark.number.clone());
                self.report(&rules::word_left_out::RULE, range, message.to_owned());
                String::new()
            }
        };
        match ended {
            true => self.out.program(&number),
            false if self.map.is_empty() => self.out.first_program(&number),
            false => {}
        }
    }

    fn remarks(&mut self, stretch: Range<usize>) {
        if !stretch.is_empty() {
            comments(self.tape.text(), stretch).iter().for_each(|comment| self.out.comment(comment));
        }
    }

    fn block(&mut self, step: &Step<'_>) {
        let from = self.out.text.len();
        let source = step.block.range.clone();
        self.out.skip = step.block.skip;
        if step.block.skip {
            self.out.forget();
            self.moves_others(step);
        }
        if step.words.first().is_some_and(|word| word.address == b':') && self.to.code.row(':').is_some() {
            self.out.align();
        }
        self.remarks(source.clone());
        self.preparatory(step);
        self.hold(step);
        self.motions(step);
        self.out.flush();
        self.behind(step, from);
        self.out.skip = false;
        if step.block.skip {
            self.out.forget();
        }
        self.noted.look(&self.out, &self.tape.view().extent(step.index));
        let lines = from..self.out.text.len();
        self.map.push((source, lines.clone()));
        let firsts = step.spans.clone().map(|span| self.tape.spans().list[span].blocks.0);
        for first in firsts.filter(|first| *first != step.index) {
            self.map.push((self.tape.reading().blocks[first].range.clone(), lines.clone()));
        }
    }

    /// Where a block can be skipped, an axis that is incremental on one side alone ends somewhere else.
    fn moves_others(&mut self, step: &Step<'_>) {
        let moved = |&axis: &usize| {
            let own = self.axes[axis].filter(|&own| self.follow.addressed(own));
            own.is_some_and(|own| self.follow.is_incremental(own) != self.out.is_incremental(axis))
        };
        let letters: Vec<String> =
            (0..self.axes.len()).filter(moved).map(|axis| self.to.axes[axis].letter.to_string()).collect();
        if !letters.is_empty() {
            let message = format!(
                "The tape that is written is right with the skip switch off: {} has dimensions of another kind there, and \
                 where this block is skipped the blocks behind it take the tool somewhere else than on this tape.",
                letters.join(", ")
            );
            self.report(&rules::skip_is_fixed::RULE, self.tape.view().extent(step.index), message);
        }
    }

    /// Blocks whose skipping changes what the blocks behind them do on this tape.
    fn skips(&mut self) {
        let view = self.tape.view();
        for (block, what) in changes_what_follows::changes(&view) {
            let range = view.extent(block);
            let said = |found: &Diagnostic| found.rule.name == "skip-is-fixed" && found.range == range;
            if !self.diagnostics.iter().any(said) {
                let message = format!(
                    "Whether this block is skipped changes {what} for the blocks behind it. The tape that is written is \
                     right with the skip switch off: it says there what is in force then."
                );
                self.report(&rules::skip_is_fixed::RULE, range, message);
            }
        }
    }

    /// Says why something was not written, and stops the tape there.
    fn take(&mut self, written: Result<(), Fault>, range: Range<usize>) {
        if let Err(fault) = written {
            self.report(&rules::does_not_fit::RULE, range, told(&fault));
            self.stop("NOT CONVERTED");
        }
    }

    /// The tape stops where something is lacking, if its format has a word for it.
    fn stop(&mut self, why: &str) {
        self.out.comment(why);
        // A format without M has no stop; the finding says what is lacking.
        let _ = self.out.function('M', 0);
    }

    /// Reports something; what is left out or written otherwise in several places alike is said once.
    fn report(&mut self, rule: &'static crate::rules::Rule, range: Range<usize>, message: String) {
        // A motion that is missing is shown wherever one is.
        let once = ![rules::span_not_converted::RULE.name, rules::does_not_fit::RULE.name].contains(&rule.name);
        let alike = |found: &&mut Diagnostic| once && found.rule.name == rule.name && found.message == message;
        match self.diagnostics.iter_mut().find(alike) {
            Some(found) => found.count += 1,
            None => {
                Sink::new(self.tape.standard(), &mut self.diagnostics).report(rule, range, message);
            }
        }
    }

    fn finish(mut self) -> Converted {
        self.out.finish();
        self.noted.tell(&self.out, &mut Sink::new(self.tape.standard(), &mut self.diagnostics));
        self.diagnostics.sort_by_key(|found| found.range.start);
        Converted { text: self.out.text, diagnostics: self.diagnostics, map: self.map }
    }
}
