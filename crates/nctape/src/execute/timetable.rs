//! The reader's time beside the machine's: which blocks are cut faster than they are read.
//!
//! A control with a buffer reads the next block while it executes one. In a run of blocks alike each is read while one
//! like it is cut, so that a block which takes longer to read than to cut makes the tool stand, and leaves a mark. The
//! time of a tape is then the sum of the longer of the two; without a buffer it is the sum of both.

use super::walk::{Fate, Walk};
use crate::Tape;
use crate::format::{Control, Format, Zeros};
use crate::read::{Block, Word};
use crate::span::{Span, SpanKind};
use std::ops::Range;

/// How long the blocks of a tape take, one entry in each list for each block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockTimes {
    /// Seconds of the spans that it ends; 0 where it moves nothing, `None` where it is not known.
    pub executing: Vec<Option<f64>>,
    /// Seconds of the reader for its rows. Behind the end of program nothing is read.
    pub reading: Vec<f64>,
    /// It cuts, and faster than it is read.
    pub starved: Vec<bool>,
}

/// The time of a whole tape with its reader.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TapeTime {
    /// Seconds of the reader for all that is read.
    pub reading: f64,
    /// Seconds of the machine alone; `None` where a span has no known time, as in all that follow.
    pub executing: Option<f64>,
    /// Seconds of both, with one block of buffer.
    pub buffered: Option<f64>,
    /// Seconds of both, without a buffer.
    pub unbuffered: Option<f64>,
    /// The blocks that cut faster than they are read.
    pub starved: usize,
    /// Seconds for which the tool stands in the cut for the reader, with a buffer as the format says.
    pub waiting: f64,
    /// What leaving zeros out would take off the tape.
    pub zeros: ZeroRows,
}

/// Rows of zeros that a dimension word can do without (ISO 2539 3.3.1, ISO 1058 3.3.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ZeroRows {
    /// Zeros before the first other digit.
    pub leading: usize,
    /// Zeros behind the last other digit.
    pub trailing: usize,
    /// Those of the one or the other that the format lets be left out, and that are punched nevertheless.
    pub permitted: usize,
}

impl ZeroRows {
    /// What the better of the two ways would save under a format that allows it.
    pub fn most(self) -> usize {
        self.leading.max(self.trailing)
    }

    pub(crate) fn of(words: &[Word], control: &Control) -> ZeroRows {
        let mut rows = ZeroRows::default();
        for word in words {
            let Some(designation) = control.designation(word.address).filter(|it| it.dimension) else { continue };
            let Some(value) = word.value else { continue };
            let (written, width) = (usize::from(word.digits), usize::from(designation.width()));
            let count = |number: u64| number.checked_ilog10().map_or(1, |tens| tens as usize + 1);
            let magnitude = value.unsigned_abs();
            // One zero at least says zero.
            let (leading, trailing) = if magnitude == 0 {
                (written.saturating_sub(1), written.saturating_sub(1))
            } else {
                // Zeros left out behind the digits are in the value, and not on the tape.
                let left_out =
                    if designation.zeros == Zeros::TrailingOmitted { width.saturating_sub(written) } else { 0 };
                let behind = (0..18).take_while(|&places| magnitude % 10_u64.pow(places + 1) == 0).count();
                let digits = count(magnitude) - left_out.min(behind);
                (written.saturating_sub(digits), behind.saturating_sub(left_out))
            };
            rows.leading += leading;
            rows.trailing += trailing;
            rows.permitted += match designation.zeros {
                Zeros::All => 0,
                Zeros::LeadingOmitted => leading,
                Zeros::TrailingOmitted => trailing,
            };
        }
        rows
    }
}

/// The seconds that a reader takes for the blocks of a span, where the span cuts in a known time: that, and those.
pub(crate) fn cut_and_read(span: &Span, blocks: &[Block], reader_speed: f64) -> Option<(f64, f64)> {
    let cuts = !matches!(span.kind, SpanKind::Rapid | SpanKind::Dwell);
    let seconds = span.seconds.filter(|_| cuts)?;
    let blocks = blocks.get(span.blocks.0..=span.blocks.1)?;
    let rows: usize = blocks.iter().map(|block| block.rows).sum();
    Some((seconds, rows as f64 / reader_speed))
}

impl Tape {
    /// How long some blocks take to execute and to read.
    pub fn times(&self, blocks: Range<usize>) -> BlockTimes {
        let all = &self.reading().blocks;
        let to = blocks.end.min(all.len());
        let from = blocks.start.min(to);
        let reader_speed = self.control().format.reader_speed();
        let mut walk = Walk::new(self.skip());
        let mut times = BlockTimes::default();
        let spans = &self.spans().list;
        let mut span = spans.partition_point(|span| span.blocks.1 < from);
        for (index, block) in all.iter().enumerate().take(to) {
            let (fate, _) = walk.meet(block, self.reading().words(block));
            if index < from {
                continue;
            }
            let (mut executing, mut starved) = (Some(0.0), false);
            while let Some(one) = spans.get(span).filter(|one| one.blocks.1 <= index) {
                executing = executing.zip(one.seconds).map(|(sum, seconds)| sum + seconds);
                starved |= cut_and_read(one, all, reader_speed).is_some_and(|(cut, read)| read > cut);
                span += 1;
            }
            times.executing.push(executing.filter(|seconds| seconds.is_finite()));
            times.reading.push(if fate == Fate::Unreached { 0.0 } else { block.rows as f64 / reader_speed });
            times.starved.push(starved);
        }
        times
    }

    /// How long the tape takes with its reader.
    pub fn time(&self) -> TapeTime {
        let control = self.control();
        let times = self.times(0..usize::MAX);
        let (mut reading, mut executing, mut longer) = (0.0, 0.0, 0.0);
        // The blocks of one span are read while one like it is cut: they wait for one another together.
        let mut spans = self.spans().list.iter().filter(|span| span.blocks.0 < span.blocks.1).peekable();
        let mut index = 0;
        while index < times.reading.len() {
            while spans.next_if(|span| span.blocks.0 < index).is_some() {}
            let last = spans.peek().filter(|span| span.blocks.0 == index).map_or(index, |span| span.blocks.1);
            let together = index..(last + 1).min(times.reading.len());
            let seconds: f64 = times.executing[together.clone()].iter().map(|one| one.unwrap_or(f64::NAN)).sum();
            let read: f64 = times.reading[together.clone()].iter().sum();
            reading += read;
            executing += seconds;
            // Unlike `f64::max` this keeps what is not known.
            longer += if read > seconds { read } else { seconds };
            index = together.end;
        }
        let known =
            |seconds: f64| Some(seconds).filter(|seconds| seconds.is_finite() && self.totals().seconds.is_some());
        let waits = self.spans().list.iter().filter_map(|span| {
            let (cut, read) = cut_and_read(span, &self.reading().blocks, control.format.reader_speed())?;
            (read > cut).then_some(if control.format.is_buffered() { read - cut } else { read })
        });
        let mut zeros = ZeroRows::default();
        let mut walk = Walk::new(self.skip());
        for block in &self.reading().blocks {
            let words = self.reading().words(block);
            if walk.meet(block, words).0 != Fate::Unreached {
                let more = ZeroRows::of(words, control);
                zeros.leading += more.leading;
                zeros.trailing += more.trailing;
                zeros.permitted += more.permitted;
            }
        }
        TapeTime {
            reading,
            executing: known(executing),
            buffered: known(longer),
            unbuffered: known(executing + reading),
            starved: times.starved.iter().filter(|starved| **starved).count(),
            waiting: waits.sum(),
            zeros,
        }
    }
}

impl TapeTime {
    /// The same in words.
    pub fn sentences(&self, format: &Format) -> Vec<String> {
        let speed = format.reader_speed();
        let mut sentences = Vec::new();
        sentences.push(match (self.executing, self.buffered, self.unbuffered) {
            (Some(alone), Some(buffered), Some(unbuffered)) => format!(
                "The machine alone takes {}; with the reader at {speed} rows/s {}, and {} without a block buffer.",
                duration(alone),
                duration(buffered),
                duration(unbuffered)
            ),
            _ => format!(
                "The reader takes {} at {speed} rows/s; the time of the machine is not known of every block.",
                duration(self.reading)
            ),
        });
        let wait = if format.is_buffered() { "" } else { ", without a buffer," };
        sentences.push(match self.starved {
            0 => "No block is cut faster than it is read.".to_owned(),
            1 => format!(
                "One block is cut faster than it is read: there the tool{wait} stands {}.",
                duration(self.waiting)
            ),
            count => format!(
                "{count} blocks are cut faster than they are read: there the tool{wait} stands {} in all.",
                duration(self.waiting)
            ),
        });
        let ZeroRows { leading, trailing, permitted } = self.zeros;
        let saved = |rows: usize| duration(rows as f64 / speed);
        if permitted > 0 {
            sentences.push(format!(
                "Zeros that the format lets be left out take {permitted} rows, {} of reading.",
                saved(permitted)
            ));
        } else if self.zeros.most() > 0 {
            sentences.push(format!(
                "Zeros before its numbers take {leading} rows, {} of reading, those behind them {trailing} rows, {}; a format \
                 may let the one or the other go.",
                saved(leading),
                saved(trailing)
            ));
        }
        sentences
    }
}

/// "0.25 s", "2 min 5 s".
fn duration(seconds: f64) -> String {
    if seconds < 60.0 {
        return format!("{} s", (seconds * 100.0).round() / 100.0);
    }
    let whole = seconds.round();
    let (minutes, rest) = ((whole / 60.0).floor(), whole % 60.0);
    if minutes < 60.0 {
        return format!("{minutes} min {rest} s");
    }
    format!("{} h {} min", (minutes / 60.0).floor(), minutes % 60.0)
}
