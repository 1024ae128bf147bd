//! Spans as motions of another format.

use super::Writer;
use super::functions::is_dwell;
use crate::execute::{FeedInForce, Followed as Step};
use crate::flatten::flatten;
use crate::format::{DwellUnit, power_of_ten};
use crate::rules::conversion as rules;
use crate::span::{Geometry, Span, SpanKind};
use crate::write::{Course, Fault, Move, Pace};

/// Chords of a whole tape at the most: some 20 MB of text.
const MOST_CHORDS: usize = 1 << 19;

impl Writer<'_> {
    pub(super) fn motions(&mut self, step: &Step<'_>) {
        let extent = self.tape.view().extent(step.index);
        let preloads = step.words.iter().any(|word| word.function(b'G') == Some(92));
        if preloads {
            let at = self.ends(|own| self.follow.addressed(own).then(|| self.follow.target(own)));
            let written = if at.iter().any(Option::is_some) { self.out.preload(&at) } else { Ok(()) };
            self.take(written, extent.clone());
        }
        for span in step.spans.clone() {
            self.span(step, span);
        }
        if is_dwell(step) {
            self.dwell(step);
        } else if step.spans.is_empty() && !preloads && !self.follow.waits() {
            self.standstill(step);
        }
    }

    /// A coordinate for every axis of the other format, as far as there is one.
    fn ends(&self, of: impl Fn(usize) -> Option<f64>) -> Vec<Option<f64>> {
        let end = |own: &Option<usize>| {
            let own = (*own)?;
            of(own).map(|at| self.in_other(self.tape.control().axes[own].letter, at))
        };
        self.axes.iter().map(end).collect()
    }

    /// A block that names axes where they stand already. That they stand there the tape may only assume.
    fn standstill(&mut self, step: &Step<'_>) {
        let end = self.ends(|own| self.follow.addressed(own).then(|| self.follow.target(own)));
        if end.iter().all(Option::is_none) || self.follow.is_thread() {
            return;
        }
        let course = if self.follow.is_rapid() { Course::Rapid } else { Course::Line };
        let written = self.out.motion(&Move { course, end, pace: Some(Pace::Unsaid) });
        self.take(written, self.tape.view().extent(step.index));
    }

    fn dwell(&mut self, step: &Step<'_>) {
        let own = self.tape.control().format.itemized.dwell.as_ref().map(|dwell| dwell.unit);
        let number = match (self.to.format.itemized.dwell.as_ref().map(|dwell| dwell.unit), own) {
            (Some(unit), Some(own)) if unit == own => self.follow.counted(),
            (Some(DwellUnit::Seconds), _) => self.follow.dwell(),
            (Some(DwellUnit::Revolutions), _) => {
                self.follow.dwell().zip(self.follow.speed()).map(|(seconds, speed)| seconds * speed / 60.0)
            }
            (None, _) => None,
        };
        match number {
            Some(number) => {
                let written = self.out.dwell(number);
                self.take(written, self.tape.view().extent(step.index));
            }
            None => {
                let word = step.words.iter().find(|word| word.function(b'G') == Some(4));
                word.into_iter().for_each(|word| self.leave_out(step, word, &rules::function_left_out::RULE));
            }
        }
    }

    fn span(&mut self, step: &Step<'_>, index: usize) {
        let (first, last) = self.tape.spans().list[index].blocks;
        let view = self.tape.view();
        let range = view.extent(first).start..view.extent(last).end;
        let span = &self.tape.spans().list[index];
        if span.kind == SpanKind::Dwell {
            return;
        }
        if span.substitute {
            let message = "This motion is not converted, because the tape does not say what it is: the check of the tape \
                           says why. The tape that is written stops there. Mend this one first.";
            self.report(&rules::span_not_converted::RULE, range, message.to_owned());
            self.stop("NOT CONVERTED");
            return;
        }
        let (start, to) = (self.tape.spans().start(index), self.tape.spans().end(index));
        let lacking = |own: &usize| start[*own] != to[*own] && !self.axes.contains(&Some(*own));
        if let Some(own) = (0..start.len()).find(lacking) {
            self.take(Err(Fault::NoWord(self.tape.control().axes[own].letter)), range);
            return;
        }
        let end = self.ends(|own| (start[own] != to[own] || self.follow.addressed(own)).then_some(to[own]));
        let pace = if self.positions(span) { None } else { Some(self.pace(span)) };
        if pace == Some(Pace::Unsaid) && !self.thread_has_leads() {
            self.no_feed(step);
        } else {
            self.unfed = false;
        }
        let written = match self.course(span) {
            Some(course) => self.out.motion(&Move { course, end, pace }),
            None => self.chords(index, pace),
        };
        self.take(written, range);
    }

    /// A cut whose feed the tape does not say: the tape that is written stops before the first of them.
    fn no_feed(&mut self, step: &Step<'_>) {
        let message = "No feed is known for this cut: it is written without one, and the tape stops before it. Give this \
                       tape an F word that says one.";
        self.report(&rules::cut_without_feed::RULE, self.tape.view().extent(step.index), message.to_owned());
        if !std::mem::replace(&mut self.unfed, true) {
            self.stop("NO FEED");
        }
    }

    /// The span is positioning, or a cut as fast as the machine moves that the other format has no feed for.
    fn positions(&self, span: &Span) -> bool {
        span.kind == SpanKind::Rapid && (self.follow.is_rapid() || !self.out.has_rapid_feed())
    }

    fn thread_has_leads(&self) -> bool {
        self.follow.is_thread() && self.follow.leads() != [0.0; 3]
    }

    /// How a span runs; `None` where the other format has nothing like it but chords.
    fn course(&self, span: &Span) -> Option<Course> {
        let length = |value: f64| self.in_other('X', value);
        let point = |at: [f64; 3]| at.map(length);
        Some(match span.geometry {
            Geometry::Line if self.positions(span) => Course::Rapid,
            Geometry::Line if self.follow.is_thread() => {
                let leads = self.follow.leads();
                let moves = |axis: usize| span.start[axis] != span.end[axis];
                let leads = std::array::from_fn(|axis| if moves(axis) { length(leads[axis]) } else { 0.0 });
                Course::Thread { code: self.thread, leads }
            }
            Geometry::Line => Course::Line,
            Geometry::Arc(arc) => {
                let third = arc.plane.axes()[2];
                if span.start[third] != span.end[third] && !self.to.helix {
                    return None;
                }
                Course::Arc { plane: arc.plane, centre: arc.centre.map(length), sweep: arc.sweep }
            }
            Geometry::Parabola { tangent } => Course::Parabola { tangent: point(tangent) },
            Geometry::Curve { control } if (0..100).any(|code| self.to.is_curve(code)) => {
                Course::Cubic { control: control.map(point) }
            }
            Geometry::Curve { .. } => return None,
        })
    }

    /// The feed of a span as the other format counts it.
    fn pace(&self, span: &Span) -> Pace {
        // A rotary axis alone has its feed in its own unit.
        let scale = self.scale[usize::from(span.angular)];
        let per_minute = span.feed.filter(|feed| *feed > 0.0).map(|feed| Pace::PerMinute {
            feed: feed * scale,
            minutes: span.seconds.map_or(span.length / feed, |seconds| seconds / 60.0),
        });
        match self.follow.feed() {
            FeedInForce::Rapid if self.out.has_rapid_feed() => Pace::Rapid,
            FeedInForce::PerRevolution(feed) => {
                let own = Pace::PerRevolution(feed * self.scale[0]);
                if self.out.counts_revolutions() { own } else { per_minute.unwrap_or(own) }
            }
            FeedInForce::Unknown => Pace::Unsaid,
            _ => per_minute.unwrap_or(Pace::Unsaid),
        }
    }

    /// A curve that the other format lacks, as straight cuts within half a least input increment of it: as far as the tape
    /// may be off anyhow. The other axes go in proportion to the path.
    fn chords(&mut self, index: usize, pace: Option<Pace>) -> Result<(), Fault> {
        let spans = self.tape.spans();
        let (start, end) = (spans.start(index), spans.end(index));
        let tolerance = self.chord_tolerance();
        let points = flatten(&spans.list, index..index + 1, tolerance).xyz;
        let count = points.len() / 3 - 1;
        self.chords += count;
        let span = &spans.list[index];
        let range = self.tape.view().extent(span.blocks.0);
        if self.chords > MOST_CHORDS {
            let message = "This curve is not converted: the chords of the tape would be more than half a million. The tape \
                           that is written stops there. Convert this one in parts.";
            self.report(&rules::span_not_converted::RULE, range, message.to_owned());
            self.stop("NOT CONVERTED");
            return Ok(());
        }
        let message = "This curve is written as straight cuts, at most half a least input increment off: the other format \
                       has no helix, or no curve of higher order.";
        self.report(&rules::curve_as_chords::RULE, range, message.to_owned());
        let pace = match pace {
            Some(Pace::PerMinute { feed, minutes }) => Some(Pace::PerMinute { feed, minutes: minutes / count as f64 }),
            other => other,
        };
        for (number, point) in points.chunks_exact(3).enumerate().skip(1) {
            let share = number as f64 / count as f64;
            let at = |own: usize| match own {
                0..3 => point[own],
                _ if number == count => end[own],
                _ => start[own] + share * (end[own] - start[own]),
            };
            let end = self.ends(|own| (start[own] != end[own] || own < 3 && varies(&points, own)).then(|| at(own)));
            let rounding = self.out.rounding;
            self.out.motion(&Move { course: Course::Line, end, pace })?;
            // No one has given the points between the ends.
            if number < count {
                self.out.rounding = rounding;
            }
        }
        Ok(())
    }

    /// Half the coarsest least input increment of the other format, in the unit of the tape.
    fn chord_tolerance(&self) -> f64 {
        let written = self.to.axes.iter().take(3).filter(|axis| axis.sign.is_some());
        let places = written.map(|axis| axis.decimals).min().unwrap_or(3);
        0.5 / power_of_ten(places) as f64 / self.scale[0]
    }
}

/// The coordinate of an axis is not the same in all points.
fn varies(points: &[f64], axis: usize) -> bool {
    points[axis..].iter().step_by(3).any(|at| *at != points[axis])
}
