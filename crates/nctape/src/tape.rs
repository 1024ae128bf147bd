//! A tape under a control: its text, and all that follows from it.

use crate::code::Rows;
use crate::diagnostic::{Diagnostic, Severity, Sink};
use crate::execute::{Bounds, Execution, Kept, Totals, execute};
use crate::flatten::{Points, flatten};
use crate::format::{Control, Format, Standard, power_of_ten};
use crate::offset::{OffsetPath, offset_path};
use crate::read::{Block, Change, Reading, Word, number, read};
use crate::report::Findings;
use crate::rules::{self, TapeView};
use crate::span::Spans;
use std::ops::Range;

/// Width of a row along the tape: ten to the inch (ISO 1154).
pub const ROW_PITCH_MILLIMETRES: f64 = 2.54;

/// A tape: the text, what was read of it, the spans and the diagnostics.
///
/// It may be edited: then it is what a fresh one would be, but only the blocks that the edit touches are read again.
///
/// ```
/// use nctape::{Format, Standard, Tape};
/// let format = Format::new(Standard::Iso2539, "N3.G2.X+42.Y+32.F4.M2*").classified("CSM 222");
/// let mut tape = Tape::new("%\nN001 G01 X+001000 Y+01000 F0300 M30\n", &format);
/// assert!(tape.diagnostics().is_empty());
/// assert_eq!(tape.spans().list[0].end, [10.0, 10.0, 0.0]);
///
/// tape.edit(14..15, "2");
/// assert_eq!(tape.spans().list[0].end, [210.0, 10.0, 0.0]);
/// ```
#[derive(Clone, Debug)]
pub struct Tape {
    text: String,
    control: Control,
    skip: bool,
    reading: Reading,
    execution: Execution,
    /// The tape executed with the optional block skip switch the other way; only where a block can be skipped.
    other: Option<Execution>,
    findings: Findings,
}

impl Tape {
    /// Reads and executes a text; the optional block skip switch is off. Any text gives a tape.
    pub fn new(text: &str, format: &Format) -> Tape {
        Tape::with_skip(text, format, false)
    }

    /// The same with the optional block skip switch in a given position.
    pub fn with_skip(text: &str, format: &Format, skip: bool) -> Tape {
        let control = Control::new(format);
        let reading = read(text, &control);
        let (execution, other) = (Execution::default(), None);
        let mut tape =
            Tape { text: text.to_owned(), control, skip, reading, execution, other, findings: Findings::default() };
        tape.execute();
        tape
    }

    /// Replaces a range of the text. The ends must lie on character boundaries of the text; an end that does not is
    /// moved forward to the next one.
    pub fn edit(&mut self, range: Range<usize>, insert: &str) {
        let boundary =
            |at: usize| (at.min(self.text.len())..=self.text.len()).find(|&at| self.text.is_char_boundary(at));
        let from = boundary(range.start).unwrap_or(self.text.len());
        let to = boundary(range.end.max(range.start)).unwrap_or(self.text.len());
        self.text.replace_range(from..to, insert);
        let change = Change { at: from, removed: to - from, inserted: insert.len() };
        let reread = self.reading.edit(&self.text, &self.control, change);
        self.execution.edit(&self.reading, &self.control, self.skip, &reread);
        self.other = match self.other.take().filter(|_| self.reading.survey().skips) {
            None => self.execute_other(),
            Some(mut other) => {
                other.edit(&self.reading, &self.control, !self.skip, &reread);
                Some(other)
            }
        };
        self.check();
    }

    /// Changes the format.
    pub fn set_format(&mut self, format: &Format) {
        self.control = Control::new(format);
        self.reading = read(&self.text, &self.control);
        self.execute();
    }

    /// Changes the position of the optional block skip switch.
    pub fn set_skip(&mut self, skip: bool) {
        if self.skip != skip {
            self.skip = skip;
            self.execute();
        }
    }

    /// Executes what was read from the start.
    fn execute(&mut self) {
        self.execution = execute(&self.reading, &self.control, self.skip);
        self.other = self.execute_other();
        self.check();
    }

    fn execute_other(&self) -> Option<Execution> {
        self.reading.survey().skips.then(|| execute(&self.reading, &self.control, !self.skip))
    }

    /// Checks the tape as a whole.
    fn check(&mut self) {
        let view = self.view();
        let mut found = Vec::new();
        let mut sink = Sink::new(self.control.standard(), &mut found);
        let foreign = rules::foreign_text::check(&view, &mut sink);
        if !foreign {
            rules::check_tape(&view, &mut sink);
        }
        self.findings = Findings::new(found, &self.reading, &self.execution, foreign);
    }

    /// The tape as the rules see it.
    pub(crate) fn view(&self) -> TapeView<'_> {
        TapeView {
            text: &self.text,
            control: &self.control,
            reading: &self.reading,
            execution: &self.execution,
            other: self.other.as_ref(),
            seen: self.reading.survey().traits,
        }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What the format makes of reading and executing.
    pub fn control(&self) -> &Control {
        &self.control
    }

    /// The standard in force.
    pub fn standard(&self) -> Standard {
        self.control.standard()
    }

    /// The position of the optional block skip switch.
    pub fn skip(&self) -> bool {
        self.skip
    }

    /// What executing it gave.
    pub(crate) fn execution(&self) -> &Execution {
        &self.execution
    }

    /// All rows of holes. See [`Tape::rows_from`] for what is visible of a long tape.
    pub fn rows(&self) -> Rows {
        self.rows_from(0, usize::MAX)
    }

    /// At most `count` rows of holes, from row `first` on.
    pub fn rows_from(&self, first: usize, count: usize) -> Rows {
        self.reading.rows(&self.text, self.control.code, self.control.end_of_block, first, count)
    }

    /// The row whose character stands at or behind a byte of the text; the count of rows behind the last one.
    pub fn row_at(&self, offset: usize) -> usize {
        self.reading.row_at(&self.text, self.control.code, offset)
    }

    /// What was read: blocks and words.
    pub fn reading(&self) -> &Reading {
        &self.reading
    }

    /// The spans of what is executed.
    pub fn spans(&self) -> &Spans {
        &self.execution.spans
    }

    /// Lengths and times.
    pub fn totals(&self) -> Totals {
        self.execution.totals
    }

    /// The room that the path takes; `None` where nothing moves.
    pub fn bounds(&self) -> Option<Bounds> {
        self.execution.bounds
    }

    /// All diagnostics, by position.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        self.diagnostics_in(0..self.text.len(), usize::MAX)
    }

    /// The diagnostics that touch a stretch of the text, by position, at most `limit`.
    pub fn diagnostics_in(&self, range: Range<usize>, limit: usize) -> Vec<Diagnostic> {
        self.findings.touching(&self.reading, range, limit)
    }

    /// How many diagnostics weigh as much.
    pub fn count(&self, severity: Severity) -> usize {
        self.findings.count(severity)
    }

    /// The path as points, within a tolerance.
    pub fn points(&self, tolerance: f64) -> Points {
        self.points_of(0..self.spans().list.len(), tolerance)
    }

    /// The points of some spans, within a tolerance.
    pub fn points_of(&self, spans: Range<usize>, tolerance: f64) -> Points {
        flatten(&self.spans().list, spans, tolerance)
    }

    /// The path of the cutter's centre within a tolerance, wherever cutter compensation is in force; `None` where it is
    /// not, or where the format states no radius of a cutter.
    pub fn offset(&self, tolerance: f64) -> Option<OffsetPath> {
        offset_of(&self.control, self.spans(), tolerance)
    }

    /// Which spans the last edit has left as they were, but for the numbers of their blocks. What was drawn of them may
    /// stand.
    pub fn last_kept(&self) -> Kept {
        self.execution.last_kept()
    }

    /// The sequence number word of a block as written, blanks left out; `None` where there is none.
    pub fn sequence(&self, block: &Block) -> Option<String> {
        let word = self.reading.words(block).first().filter(|word| word.is_sequence())?;
        Some(self.text[self.reading.range(block, word)].replace(' ', ""))
    }

    /// The value of a word in the unit of the format; `None` where its digits do not say it.
    pub fn value(&self, word: &Word) -> Option<f64> {
        word.value.map(|value| number::in_unit(&self.control, word.address, value))
    }

    /// How many blocks the last edit has read and executed again; at first, all of them.
    pub fn last_work(&self) -> (usize, usize) {
        (self.reading.last_read(), self.execution.last_executed())
    }

    /// The rows of a block.
    pub fn rows_of(&self, block: &Block) -> Range<usize> {
        block.row..block.row + block.rows
    }
}

/// The path of the cutter's centre that a control makes of some spans.
pub(crate) fn offset_of(control: &Control, spans: &Spans, tolerance: f64) -> Option<OffsetPath> {
    let radius = control.format.itemized.cutter_radius?.0;
    let step = control.axes.iter().take(3).filter(|axis| axis.sign.is_some());
    let step = step.map(|axis| 1.0 / power_of_ten(axis.decimals) as f64).fold(0.0, f64::max);
    offset_path(spans, radius, step, tolerance)
}
