//! What is known of the spans between two marks: so that an edit need not go through those of the whole tape.

use super::timetable::cut_and_read;
use super::totals::Bounds;
use crate::read::Block;
use crate::span::Span;

/// The spans between two marks, taken together. Nothing in it hangs on where the marks stand: any way of cutting the
/// tape into sections comes to the same when they are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Section {
    /// The room that they take; `None` around none.
    pub bounds: Option<Bounds>,
    /// Those that are cut faster than they are read.
    pub starved: Starved,
}

/// Spans that are cut faster than they are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Starved {
    /// The first of them, by its place in the list of spans.
    pub first: Option<usize>,
    /// How many they are.
    pub count: usize,
    /// How much longer they are read than cut, together: whole nanoseconds, because their sum does not hang on the order
    /// in which they are added.
    nanoseconds: u64,
}

impl Starved {
    /// How much longer they are read than cut, together, in seconds.
    pub(crate) fn wait(self) -> f64 {
        self.nanoseconds as f64 / 1e9
    }

    fn with(self, other: Starved) -> Starved {
        Starved {
            first: self.first.or(other.first),
            count: self.count + other.count,
            nanoseconds: self.nanoseconds.saturating_add(other.nanoseconds),
        }
    }
}

impl Section {
    /// What is known of `spans`, the first of which is number `first`.
    pub(super) fn of(spans: &[Span], first: usize, blocks: &[Block], reader_speed: f64) -> Section {
        let mut starved = Starved::default();
        for (place, span) in spans.iter().enumerate() {
            let times = cut_and_read(span, blocks, reader_speed);
            if let Some((cut, read)) = times.filter(|(cut, read)| read > cut) {
                let nanoseconds = ((read - cut) * 1e9).round() as u64;
                starved = starved.with(Starved { first: Some(first + place), count: 1, nanoseconds });
            }
        }
        Section { bounds: Bounds::of(spans), starved }
    }

    /// This and the next one.
    pub(super) fn with(self, next: Section) -> Section {
        let both = self.bounds.zip(next.bounds).map(|(one, other)| one.with(other));
        Section { bounds: both.or(self.bounds).or(next.bounds), starved: self.starved.with(next.starved) }
    }

    /// The same, behind so many more or fewer spans.
    pub(super) fn moved(mut self, shift: usize) -> Section {
        self.starved.first = self.starved.first.map(|first| first.wrapping_add(shift));
        self
    }
}
