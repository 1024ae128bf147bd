//! Today's decimal G-code as a tape of a format.

use super::Converted;
use super::fault::told;
use super::gcode::{Line, Word, lines};
use super::noted::Noted;
use crate::diagnostic::{Diagnostic, Sink};
use crate::execute::circle::ArcBlock;
use crate::execute::parabola::Parabola;
use crate::format::{Control, FeedCoding, FeedUnit, Format, Plane, Unit};
use crate::rules::conversion as rules;
use crate::write::{Course, Fault, Move, Pace, TapeWriter};
use std::ops::Range;

/// Writes decimal G-code as a tape.
pub(super) fn write(source: &str, to: &Format) -> Converted {
    let control = Control::new(to);
    let mut reader = Reader::new(source, &control);
    for line in lines(source) {
        reader.line(&line);
    }
    reader.finish()
}

/// What the interpolation in force is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Motion {
    Rapid,
    Line,
    Arc {
        clockwise: bool,
    },
    Spline,
    /// A cycle, a thread, a probe: whatever it is, a tape has no such motion here.
    Other,
}

struct Reader<'a> {
    source: &'a str,
    control: &'a Control,
    writer: TapeWriter<'a>,
    map: Vec<(Range<usize>, Range<usize>)>,
    diagnostics: Vec<Diagnostic>,
    noted: Noted,
    /// Units of the format in one of the text.
    scale: f64,
    incremental: bool,
    absolute_centres: bool,
    plane: Plane,
    motion: Option<Motion>,
    feed_kind: u16,
    feed: Option<f64>,
    speed: Option<f64>,
    /// Where every axis stands, in the unit of the format, as exactly as the text says it.
    at: Vec<f64>,
}

impl<'a> Reader<'a> {
    fn new(source: &'a str, control: &'a Control) -> Reader<'a> {
        let writer = TapeWriter::new(control);
        let at = (0..control.axes.len()).map(|axis| writer.position(axis)).collect();
        Reader {
            source,
            control,
            writer,
            map: Vec::new(),
            diagnostics: Vec::new(),
            noted: Noted::default(),
            // A text that does not say its unit has that of the format.
            scale: 1.0,
            incremental: false,
            absolute_centres: false,
            plane: Plane::Xy,
            motion: None,
            feed_kind: 94,
            feed: None,
            speed: None,
            at,
        }
    }

    fn line(&mut self, line: &Line<'_>) {
        let from = self.writer.text.len();
        line.comments.iter().for_each(|comment| self.writer.comment(comment));
        if let Some(stray) = &line.stray {
            let message = "This is no word of a letter and a number: parameters, expressions and subprograms are not \
                           worked out. The line is not converted, and the tape stops there.";
            self.refuse(stray.clone(), message.to_owned());
        } else if !line.words.is_empty() {
            self.writer.skip = line.skip;
            if line.skip {
                self.writer.forget();
            }
            self.words(line);
            self.writer.skip = false;
            if line.skip {
                self.writer.forget();
            }
        }
        self.noted.look(&self.writer, &line.range);
        let to = self.writer.text.len();
        if !line.words.is_empty() {
            self.map.push((line.range.clone(), from..to));
        }
    }

    fn words(&mut self, line: &Line<'_>) {
        let functions = |letter: char| line.words.iter().filter(move |word| word.letter == letter);
        let mut dwell = None;
        for word in functions('G') {
            match word.tenths() {
                Some(40) => dwell = Some(word),
                code => self.preparatory(word, code),
            }
        }
        for word in &line.words {
            match word.letter {
                'F' => self.feed = Some(word.value),
                'S' => self.speed = Some(word.value),
                _ => {}
            }
        }
        self.functions(line);
        if let Some(word) = dwell {
            let seconds = functions('P').next().map(|word| word.value).filter(|seconds| *seconds >= 0.0);
            match seconds.and_then(|seconds| self.dwell(seconds)) {
                Some(number) => {
                    let written = self.writer.dwell(number);
                    self.take(written, word.range.clone());
                }
                None => self.leave_out(word, &rules::function_left_out::RULE),
            }
        } else {
            self.motion(line);
        }
        for word in functions('M').filter(|word| matches!(word.tenths(), Some(0 | 10 | 20 | 300 | 600))) {
            let written = self.writer.function('M', word.value as u8);
            self.take(written, word.range.clone());
        }
    }

    /// What the word of a dwell counts, for so many seconds.
    fn dwell(&self, seconds: f64) -> Option<f64> {
        match self.control.format.itemized.dwell.as_ref()?.unit {
            crate::format::DwellUnit::Seconds => Some(seconds),
            crate::format::DwellUnit::Revolutions => self.speed.map(|speed| seconds * speed / 60.0),
        }
    }

    /// A preparatory function by its number in tenths.
    fn preparatory(&mut self, word: &Word, code: Option<u16>) {
        match code {
            Some(0) => self.motion = Some(Motion::Rapid),
            Some(10) => self.motion = Some(Motion::Line),
            Some(code @ (20 | 30)) => self.motion = Some(Motion::Arc { clockwise: code == 20 }),
            Some(51) => self.motion = Some(Motion::Spline),
            Some(170) => self.plane = Plane::Xy,
            Some(180) => self.plane = Plane::Zx,
            Some(190) => self.plane = Plane::Yz,
            Some(code @ (200 | 210)) => {
                let (text, own) = (if code == 200 { 25.4 } else { 1.0 }, self.control.unit);
                self.scale = text / if own == Unit::Inch { 25.4 } else { 1.0 };
            }
            Some(900) => self.incremental = false,
            Some(910) => self.incremental = true,
            Some(901) => self.absolute_centres = true,
            Some(911) => self.absolute_centres = false,
            Some(code @ (930 | 940 | 950)) => {
                if self.feed_kind != code / 10 {
                    self.feed = None;
                }
                self.feed_kind = code / 10;
            }
            // The end of cycles, and modes in which a tape control is anyhow. G54 is where the origin is taken to be.
            Some(800) => self.motion = None,
            Some(400 | 490 | 540 | 610 | 611 | 640 | 970) => {}
            _ => {
                if matches!(code, Some(50 | 52 | 280 | 300 | 330..=389 | 530 | 730..=899 | 920)) {
                    self.motion = Some(Motion::Other);
                }
                self.leave_out(word, &rules::function_left_out::RULE);
            }
        }
    }

    /// Tool, speed and functions: those that a motion waits for, and those that LinuxCNC carries out before it.
    fn functions(&mut self, line: &Line<'_>) {
        let value = |letter: char| line.words.iter().find(|word| word.letter == letter);
        let range = line.range.clone();
        if let Some(word) = value('T') {
            let change = line.words.iter().any(|word| word.letter == 'M' && word.tenths() == Some(60));
            let written = self.writer.functions(Some(word.value as i64), None, change.then_some(6));
            self.take(written, word.range.clone());
        }
        let mut speed = value('S').map(|word| word.value);
        for word in line.words.iter().filter(|word| word.letter == 'M') {
            let code = word.tenths().filter(|tenths| tenths % 10 == 0).map(|tenths| tenths / 10);
            match code {
                Some(0 | 1 | 2 | 30 | 60) => {}
                Some(6) if value('T').is_some() => {}
                Some(code @ (3..=9)) => {
                    let speed = if code < 5 { speed.take() } else { None };
                    let written = self.writer.functions(None, speed, Some(code as u8));
                    self.take(written, word.range.clone());
                }
                _ => self.leave_out(word, &rules::function_left_out::RULE),
            }
        }
        let written = self.writer.functions(None, speed, None);
        self.take(written, range);
        let known = |word: &&Word| !"NGMFSTIJKRPXYZABCUVW".contains(word.letter);
        for word in line.words.iter().filter(known) {
            self.leave_out(word, &rules::word_left_out::RULE);
        }
    }

    fn motion(&mut self, line: &Line<'_>) {
        let axes: Vec<&Word> = line.words.iter().filter(|word| "XYZABCUVW".contains(word.letter)).collect();
        let centred = line.words.iter().any(|word| "IJKR".contains(word.letter));
        if axes.is_empty() && !(centred && matches!(self.motion, Some(Motion::Arc { .. }))) {
            return;
        }
        let mut end: Vec<Option<f64>> = vec![None; self.at.len()];
        for word in axes {
            let Some(axis) = self.control.axes.iter().position(|axis| axis.letter == word.letter) else {
                self.leave_out(word, &rules::word_left_out::RULE);
                continue;
            };
            let scale = match word.letter {
                'A' | 'B' | 'C' if self.control.angles() == crate::format::Angles::Turns => 1.0 / 360.0,
                'A' | 'B' | 'C' => 1.0,
                _ => self.scale,
            };
            let value = word.value * scale;
            end[axis] = Some(if self.incremental { self.at[axis] + value } else { value });
        }
        let range = line.range.clone();
        if line.skip {
            self.skips(&end, &range);
        }
        let Some(motion) = self.motion.filter(|motion| *motion != Motion::Other) else {
            let message = "These axes move under no interpolation that a tape has: a cycle, a thread, a move to a \
                           reference, or none was given. The line is not converted, and the tape stops there.";
            self.refuse(range, message.to_owned());
            self.arrive(&end);
            return;
        };
        let at = |end: &[Option<f64>], axis: usize| end[axis].unwrap_or(self.at[axis]);
        let (start, to): ([f64; 3], [f64; 3]) =
            (std::array::from_fn(|axis| self.at[axis]), std::array::from_fn(|axis| at(&end, axis)));
        let (course, length) = match motion {
            Motion::Rapid => (Some(Course::Rapid), 0.0),
            Motion::Line => {
                let way = (0..3).map(|axis| to[axis] - start[axis]).fold(0.0, libm::hypot);
                let other = (3..end.len()).map(|axis| at(&end, axis) - self.at[axis]).fold(0.0, libm::hypot);
                (Some(Course::Line), if way > 0.0 { way } else { other })
            }
            Motion::Arc { clockwise } => self.arc(line, start, to, clockwise),
            Motion::Spline => self.spline(line, start, to),
            Motion::Other => (None, 0.0),
        };
        let Some(course) = course else {
            let message = "The words of this line give no arc or parabola that ends where they say. The line is not \
                           converted, and the tape stops there.";
            self.refuse(range, message.to_owned());
            self.arrive(&end);
            return;
        };
        let written = self.writer.motion(&Move { course, end: end.clone(), pace: self.pace(length) });
        self.take(written, range);
        self.arrive(&end);
    }

    /// Where a line can be skipped, an axis that is incremental on one side alone ends somewhere else.
    fn skips(&mut self, end: &[Option<f64>], range: &Range<usize>) {
        let moved = |&axis: &usize| {
            end[axis].is_some_and(|end| end != self.at[axis]) && self.incremental != self.writer.is_incremental(axis)
        };
        let letters: Vec<String> =
            (0..end.len()).filter(moved).map(|axis| self.control.axes[axis].letter.to_string()).collect();
        if !letters.is_empty() {
            let message = format!(
                "The tape is right with the skip switch off: {} has dimensions of another kind there, and where this line is \
                 skipped the lines behind it take the tool somewhere else than here.",
                letters.join(", ")
            );
            self.report(&rules::skip_is_fixed::RULE, range.clone(), message);
        }
    }

    fn arrive(&mut self, end: &[Option<f64>]) {
        for (at, end) in self.at.iter_mut().zip(end) {
            *at = end.unwrap_or(*at);
        }
    }

    /// An arc by its centre or its radius, and its length.
    fn arc(&self, line: &Line<'_>, start: [f64; 3], end: [f64; 3], clockwise: bool) -> (Option<Course>, f64) {
        let [first, second, third] = self.plane.axes();
        let value = |letter: char| line.words.iter().find(|word| word.letter == letter).map(|word| word.value);
        let (from, to) = ([start[first], start[second]], [end[first], end[second]]);
        let offsets = [first, second].map(|axis| value(['I', 'J', 'K'][axis]).map(|value| value * self.scale));
        let centre = match (offsets, value('R').map(|radius| radius * self.scale)) {
            ([None, None], Some(radius)) => centre_by_radius(from, to, radius, clockwise),
            ([None, None], None) => None,
            (offsets, _) => Some(std::array::from_fn(|axis| match (offsets[axis], self.absolute_centres) {
                (Some(value), true) => value,
                (Some(value), false) => from[axis] + value,
                (None, _) => from[axis],
            })),
        };
        let Some(centre) = centre.filter(|_| value('P').is_none_or(|turns| turns == 1.0)) else { return (None, 0.0) };
        let radius = libm::hypot(from[0] - centre[0], from[1] - centre[1]);
        // What LinuxCNC accepts, as its manual states it.
        let least = if self.control.unit == Unit::Inch { 0.0005 } else { 0.005 };
        let tolerance = f64::max(least, 0.001 * radius);
        let block = ArcBlock { plane: self.plane, start: from, end: to, clockwise, tolerance };
        match block.about(centre) {
            Ok(arc) => {
                let length = libm::hypot(radius * arc.sweep, end[third] - start[third]);
                (Some(Course::Arc { plane: self.plane, centre, sweep: arc.sweep }), length)
            }
            Err(_) => (None, 0.0),
        }
    }

    /// G5.1: a quadratic spline in XY, whose control point is where the tangents meet.
    fn spline(&self, line: &Line<'_>, start: [f64; 3], end: [f64; 3]) -> (Option<Course>, f64) {
        let offset = |letter: char| {
            line.words.iter().find(|word| word.letter == letter).map_or(0.0, |word| word.value * self.scale)
        };
        let tangent = [start[0] + offset('I'), start[1] + offset('J'), start[2]];
        if self.plane != Plane::Xy || start[2] != end[2] || tangent == start {
            return (None, 0.0);
        }
        (Some(Course::Parabola { tangent }), Parabola { start, tangent, end }.length())
    }

    /// The feed of a motion of some length, as the format counts it; none where it is not known.
    fn pace(&self, length: f64) -> Option<Pace> {
        let feed = self.feed.filter(|feed| *feed > 0.0)?;
        let per_minute = match self.feed_kind {
            93 => Some(length * feed),
            95 => self.speed.map(|speed| feed * self.scale * speed),
            _ => Some(feed * self.scale),
        };
        let per_revolution = self.control.feed_unit == FeedUnit::PerRevolution;
        if per_revolution && self.control.feed != FeedCoding::TimeReciprocal {
            let known = (self.feed_kind == 95).then_some(feed * self.scale);
            let speed = self.speed.filter(|speed| *speed > 0.0);
            return known.or_else(|| Some(per_minute? / speed?)).map(Pace::PerRevolution);
        }
        let feed = per_minute.filter(|feed| feed.is_finite() && *feed > 0.0)?;
        Some(Pace::PerMinute { feed, minutes: length / feed })
    }

    /// Says why something was not written.
    fn take(&mut self, written: Result<(), Fault>, range: Range<usize>) {
        if let Err(fault) = written {
            let message = told(&fault);
            self.report(&rules::does_not_fit::RULE, range, message);
            self.stop();
        }
    }

    fn refuse(&mut self, range: Range<usize>, message: String) {
        self.report(&rules::span_not_converted::RULE, range, message);
        self.stop();
    }

    /// The tape stops where something is lacking, if its format has a word for it.
    fn stop(&mut self) {
        self.writer.comment("NOT CONVERTED");
        let _ = self.writer.function('M', 0);
    }

    fn leave_out(&mut self, word: &Word, rule: &'static crate::rules::Rule) {
        let written = &self.source[word.range.clone()];
        let message = format!(
            "{written} is left out: the tape has no such word, or it means something else there. What it does on the \
             machine is to be put in by hand."
        );
        if !self.diagnostics.iter().any(|found| found.rule.name == rule.name && found.message == message) {
            self.report(rule, word.range.clone(), message);
        } else if let Some(found) =
            self.diagnostics.iter_mut().find(|found| found.rule.name == rule.name && found.message == message)
        {
            found.count += 1;
        }
    }

    fn report(&mut self, rule: &'static crate::rules::Rule, range: Range<usize>, message: String) {
        Sink::new(self.control.standard(), &mut self.diagnostics).report(rule, range, message);
    }

    fn finish(mut self) -> Converted {
        self.writer.finish();
        self.noted.tell(&self.writer, &mut Sink::new(self.control.standard(), &mut self.diagnostics));
        self.diagnostics.sort_by_key(|found| found.range.start);
        Converted { text: self.writer.text, diagnostics: self.diagnostics, map: self.map }
    }
}

/// The centre of an arc by its radius: the shorter way round where that is positive.
fn centre_by_radius(from: [f64; 2], to: [f64; 2], radius: f64, clockwise: bool) -> Option<[f64; 2]> {
    let chord = [to[0] - from[0], to[1] - from[1]];
    let length = libm::hypot(chord[0], chord[1]);
    let half = length / 2.0;
    if length == 0.0 || radius.abs() < half * 0.999 {
        return None;
    }
    let height = (radius * radius - half * half).max(0.0).sqrt();
    // Clockwise the centre of the shorter arc lies to the right of the chord.
    let side = if clockwise == (radius > 0.0) { height } else { -height };
    let normal = [chord[1] / length, -chord[0] / length];
    Some([from[0] + chord[0] / 2.0 + side * normal[0], from[1] + chord[1] / 2.0 + side * normal[1]])
}
