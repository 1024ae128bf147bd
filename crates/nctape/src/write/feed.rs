//! How fast a motion is, as words of a format.

use super::motion::Move;
use super::{Fault, TapeWriter};
use crate::format::{ArcFeed, Control, FeedCoding, FeedUnit, Standard};
use crate::speed::{Coding, Speed};

/// How fast a motion is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Pace {
    /// Unit per minute along the path, beside the minutes that the motion takes.
    PerMinute { feed: f64, minutes: f64 },
    /// Unit per revolution of the spindle.
    PerRevolution(f64),
    /// As fast as the machine moves.
    Rapid,
    /// What it was before: no word says it.
    Unsaid,
}

/// The number that a time-reciprocal F says of a motion that takes so many minutes; any other feed is itself.
fn rate(control: &Control, value: f64, sweep: Option<f64>) -> f64 {
    match (control.feed, sweep, control.arc_feed) {
        (FeedCoding::TimeReciprocal, Some(sweep), ArcFeed::Radians) => sweep.abs() / value,
        (FeedCoding::TimeReciprocal, ..) => 1.0 / value,
        _ => value,
    }
}

impl Control {
    /// The preparatory function that stands for the kind of feed which the format itself has.
    pub(super) fn own_feed_kind(&self) -> u8 {
        match (self.feed, self.feed_unit) {
            (FeedCoding::TimeReciprocal, _) => 93,
            (_, FeedUnit::PerMinute) => 94,
            (_, FeedUnit::PerRevolution) => 95,
        }
    }
}

impl TapeWriter<'_> {
    /// The F word of a cut, where another is in force. `share`: how much of the motion the block is.
    pub(super) fn feed(
        &mut self,
        motion: &Move,
        share: f64,
        sweep: Option<f64>,
    ) -> Result<Option<(char, String)>, Fault> {
        let pace = motion.pace.ok_or(Fault::NoFeed)?;
        let own = self.control.own_feed_kind();
        let (kind, value) = match pace {
            Pace::Unsaid => return Ok(None),
            Pace::Rapid => return self.rapid_feed(own),
            Pace::PerMinute { minutes, .. } if own == 93 => (93, minutes * share),
            Pace::PerMinute { feed, .. } => (94, feed),
            Pace::PerRevolution(feed) => (95, feed),
        };
        self.turn_feed(kind)?;
        let word = if kind == 93 || own != 93 {
            self.speed_word('F', value, sweep)?
        } else {
            // Under G94 and G95 a control of the reciprocal of time has its feeds as they are.
            self.coded('F', Coding::of(self.control, b'F').under(FeedCoding::Direct), value)?
        };
        // Every block of a time-reciprocal feed has its own.
        if kind != 93 && self.modal.feed.as_ref() == Some(&word) {
            return Ok(None);
        }
        self.modal.feed = Some(word.clone());
        Ok(Some(('F', word)))
    }

    /// The code of rapid traverse, as far as the coding has one.
    fn rapid_feed(&mut self, own: u8) -> Result<Option<(char, String)>, Fault> {
        self.designation('F')?;
        self.turn_feed(own)?;
        let code = Coding::of(self.control, b'F').rapid().ok_or(Fault::NoFeed)?.to_string();
        let changes = self.modal.feed.replace(code.clone()) != Some(code.clone());
        Ok(changes.then_some(('F', code)))
    }

    /// Turns to another kind of feed, in a block of its own.
    fn turn_feed(&mut self, kind: u8) -> Result<(), Fault> {
        if self.modal.feed_kind == Some(kind) {
            return Ok(());
        }
        if self.control.standard() == Standard::Iso1058 {
            return Err(Fault::NoFeed);
        }
        let word = self.code_word('G', i64::from(kind))?;
        self.separate(('G', word));
        self.changes_feed_kind = true;
        (self.modal.feed_kind, self.modal.feed) = (Some(kind), None);
        Ok(())
    }

    /// The number of a spindle speed as its word.
    pub(crate) fn spindle(&mut self, speed: f64) -> Result<String, Fault> {
        self.speed_word('S', speed, None)
    }

    /// The kind of feed of the format itself is per revolution.
    pub(crate) fn counts_revolutions(&self) -> bool {
        self.control.own_feed_kind() == 95
    }

    /// The coding of F has a code for rapid traverse.
    pub(crate) fn has_rapid_feed(&self) -> bool {
        self.designation('F').is_ok() && Coding::of(self.control, b'F').rapid().is_some()
    }

    /// The word of a feed or a speed; `sweep` is that of an arc, in radians.
    pub(super) fn speed_word(&mut self, address: char, value: f64, sweep: Option<f64>) -> Result<String, Fault> {
        let letter = address as u8;
        let value = if letter == b'F' { rate(self.control, value, sweep) } else { value };
        self.coded(address, Coding::of(self.control, letter), value)
    }

    fn coded(&mut self, address: char, coding: Coding<'_>, value: f64) -> Result<String, Fault> {
        self.designation(address)?;
        let code = coding.encode(value).map_err(|why| Fault::Speed { address, value, why })?;
        if let Ok(Speed::Is(written)) = coding.decode(code) {
            let off = (written - value).abs();
            self.speed_rounding = self.speed_rounding.max(if off == 0.0 { 0.0 } else { off / value.max(written) });
        }
        Ok(code.to_string())
    }
}
