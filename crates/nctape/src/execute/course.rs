//! How a tape passes through the control: block by block, with the time that each takes.

use super::walk::{Fate, Walk, stop_of};
use crate::Tape;
use crate::format::Unit;
use crate::read::Word;
use crate::span::{Span, SpanKind};
use std::ops::Range;

/// What is taken for a speed that neither tape nor format says, in millimetres and in inches per minute. The paces
/// are of the order of the machines of the time, and so round that nobody takes them for a figure of the tape.
const RAPID: [f64; 2] = [5000.0, 200.0];
const CUTTING: [f64; 2] = [300.0, 12.0];
/// Seconds for a move of rotary axes alone whose time is not known, and for such a dwell: neither has a length along
/// the path.
const TURNING: f64 = 2.0;

/// Seconds at the most that one span takes here, some thirty years. A feed may be so small that the sum over a tape
/// would be no number.
const MOST_SECONDS: f64 = 1e9;

/// How a tape passes through the control. The times of motions that are not known are assumed: it serves to show the
/// tape at work, not to reckon its time, which is [`crate::Totals::seconds`].
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// What becomes of each block.
    pub steps: Vec<Step>,
    /// The seconds of each span, known or assumed.
    pub span_seconds: Vec<f64>,
    /// The spans whose time is assumed.
    pub assumed: usize,
    /// What is assumed of them, in words; `None` where nothing is.
    pub note: Option<String>,
    /// The pace of blocks that move nothing, in rows per second.
    pub reader_speed: f64,
}

/// One block on its way.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Its rows.
    pub rows: Range<usize>,
    /// What becomes of it.
    pub fate: Fate,
    /// Why the control waits behind it.
    pub stop: Stop,
    /// The spans that are carried out with it: those of which it is the last block.
    pub spans: Range<usize>,
    /// How long it takes: the time of its spans, or that of the reader where it has none.
    pub seconds: f64,
}

/// Why a control waits behind a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// It does not.
    None,
    /// Program stop: M00.
    Program,
    /// End of program or tape: M02, M30.
    End,
}

impl Stop {
    /// Its place in the interface: 0 for none.
    pub fn index(self) -> usize {
        self as usize
    }
}

impl Tape {
    /// How the tape passes through the control, with the skip switch as it is.
    pub fn course(&self) -> Course {
        let control = self.control();
        let by_unit = |[millimetre, inch]: [f64; 2]| if control.unit == Unit::Inch { inch } else { millimetre };
        let (rapid, cutting) = (by_unit(RAPID), by_unit(CUTTING));
        let reader_speed = control.format.reader_speed();

        let spans = &self.spans().list;
        let seconds = |span: &Span| span.seconds.unwrap_or_else(|| assumed(span, rapid, cutting)).min(MOST_SECONDS);
        let span_seconds: Vec<f64> = spans.iter().map(seconds).collect();

        let mut walk = Walk::new(self.skip());
        let mut span = 0;
        let mut steps = Vec::with_capacity(self.reading().blocks.len());
        for (index, block) in self.reading().blocks.iter().enumerate() {
            let words = self.reading().words(block);
            let (fate, _) = walk.meet(block, words);
            let rows = self.rows_of(block);
            let first = span;
            span += spans[first..].iter().take_while(|span| span.blocks.1 <= index).count();
            let seconds = if first == span {
                (rows.len() as f64 / reader_speed).min(MOST_SECONDS)
            } else {
                span_seconds[first..span].iter().sum()
            };
            steps.push(Step { rows, fate, stop: stop(fate, words), spans: first..span, seconds });
        }
        let unknown = || spans.iter().filter(|span| span.seconds.is_none());
        let unit = control.unit.name();
        let mut notes = Vec::new();
        for (name, pace, rapids) in [("rapid", rapid, true), ("cutting", cutting, false)] {
            if unknown().any(|span| !stands(span) && (span.kind == SpanKind::Rapid) == rapids) {
                notes.push(format!("{name} {pace} {unit}/min"));
            }
        }
        if unknown().any(|span| span.angular) {
            notes.push(format!("{TURNING} s for a turn without feed"));
        }
        if unknown().any(|span| span.kind == SpanKind::Dwell) {
            notes.push(format!("{TURNING} s for a dwell of unknown time"));
        }
        let note = (!notes.is_empty()).then(|| format!("Assumed for the replay: {}", notes.join(", ")));
        Course { steps, span_seconds, assumed: unknown().count(), note, reader_speed }
    }
}

fn stop(fate: Fate, words: &[Word]) -> Stop {
    match stop_of(words) {
        Some(0) if fate == Fate::Executed => Stop::Program,
        Some(_) if fate == Fate::Executed => Stop::End,
        _ => Stop::None,
    }
}

/// It has no length along a path.
fn stands(span: &Span) -> bool {
    span.angular || span.kind == SpanKind::Dwell
}

/// The seconds of a span that nobody knows.
fn assumed(span: &Span, rapid: f64, cutting: f64) -> f64 {
    if stands(span) {
        return TURNING;
    }
    span.length / if span.kind == SpanKind::Rapid { rapid } else { cutting } * 60.0
}
