//! Dwell (G04): the tool stands for as long as a word of the block says. ISO 1056 leaves to the builder which word that
//! is and what it counts (`dwell` in the itemized data).

use super::event::EventKind;
use super::state::State;
use crate::format::DwellUnit;
use crate::read::{Word, number};
use crate::span::{Geometry, Span, SpanKind};

/// The word that says how long a block dwells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pause {
    /// Its place in the block.
    pub place: usize,
    /// What it says; `None` where its number could not be read.
    pub counted: Option<f64>,
    /// How long; `None` where its number could not be read, or counts revolutions of a spindle whose speed is not known.
    pub seconds: Option<f64>,
}

impl State<'_> {
    /// The block dwells, and the word is the one that says how long: it is then nothing else.
    pub(super) fn is_dwell(&self, word: &Word) -> bool {
        self.dwells && self.control.format.itemized.dwell.as_ref().is_some_and(|it| it.address == word.letter())
    }

    pub(super) fn take_dwell(&mut self, place: usize, word: &Word) {
        // An F or S word that dwells is a plain number, whatever the coding of feeds.
        let counted = word.value.map(|value| number::in_unit(self.control, word.address, value));
        self.pause = Some(Pause { place, counted, seconds: None });
    }

    /// Lets the tool stand where it is, once all words of the block are taken.
    pub(super) fn stand(&mut self) {
        let Some(dwell) = self.control.format.itemized.dwell.as_ref().filter(|_| self.dwells) else { return };
        let Some(mut pause) = self.pause else {
            self.note(EventKind::NotCarriedOut(4));
            return;
        };
        let seconds = match dwell.unit {
            DwellUnit::Seconds => pause.counted,
            // The speed of the block itself, too, whatever its place there.
            DwellUnit::Revolutions => {
                let speed = self.speed.filter(|speed| *speed > 0.0);
                pause.counted.zip(speed).map(|(turns, speed)| turns / speed * 60.0)
            }
        };
        pause.seconds = seconds.filter(|seconds| seconds.is_finite() && *seconds >= 0.0);
        self.pause = Some(pause);
        if pause.counted == Some(0.0) {
            return;
        }
        if pause.counted.is_some_and(|counted| counted < 0.0) {
            self.note(EventKind::NotCarriedOut(4));
            return;
        }
        // The second block of a span follows its first one: a dwell between them leaves it unfinished.
        self.finish_span();
        self.target = self.position;
        let (start, at) = (self.position, self.point(&self.position));
        let span = Span {
            kind: SpanKind::Dwell,
            blocks: (self.block, self.block),
            geometry: Geometry::Line,
            start: at,
            end: at,
            length: 0.0,
            angular: false,
            feed: None,
            seconds: pause.seconds,
            substitute: false,
        };
        self.push_span(span, &start);
    }
}
