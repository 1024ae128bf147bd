//! What a format says of the machine, whatever the tape: the data that no listing shows.

use super::{Control, DwellUnit, FeedCoding, FeedUnit, Format};
use crate::span::SpanKind;

/// Rows that a reader draws past its head in a second, where nothing is stated.
pub const READER_SPEED: f64 = 300.0;

/// Why the time of a span is not known, and the field of the format that would say it, if one would.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Untimed {
    /// In words.
    pub sentence: &'static str,
    /// The path of the field, "itemized.rapid".
    pub field: Option<&'static str>,
}

impl Format {
    /// Rows that the reader draws past its head in a second.
    pub fn reader_speed(&self) -> f64 {
        // A tape has fewer rows than 10^12; below this their time would be no number any more.
        self.itemized.reader_speed.map_or(READER_SPEED, |speed| speed.0.max(1e-200))
    }

    /// This format on the machine of another: the reader is taken from it, and under the same unit the rapid traverse
    /// and the cutter, as far as this one does not state them.
    ///
    /// A format that was found for a listing says how its words are read; what the machine is like it cannot know, and
    /// what was known before holds on. The set point is of the tape, not of the machine: that of another one would move
    /// the path. The travel is left out: it judges coordinates, and another reading of the words has others.
    pub fn on_machine_of(&self, other: &Format) -> Format {
        let mut format = self.clone();
        let same_unit = Control::new(self).unit == Control::new(other).unit;
        let (own, known) = (&mut format.itemized, &other.itemized);
        own.reader_speed = own.reader_speed.or(known.reader_speed);
        own.buffered = own.buffered.or(known.buffered);
        if same_unit {
            own.rapid = own.rapid.or(known.rapid);
            own.cutter_radius = own.cutter_radius.or(known.cutter_radius);
        }
        format
    }

    /// One block is read ahead while another is executed: yes, unless the format states otherwise.
    pub fn is_buffered(&self) -> bool {
        self.itemized.buffered.unwrap_or(true)
    }

    /// Why a moving span of this kind has no known time.
    pub fn why_untimed(&self, kind: SpanKind) -> Untimed {
        let control = Control::new(self);
        let untimed = |sentence, field| Untimed { sentence, field };
        if kind == SpanKind::Rapid {
            return untimed("The rapid traverse of the machine is not stated.", Some("itemized.rapid"));
        }
        if kind == SpanKind::Dwell {
            let unit = self.itemized.dwell.as_ref().map(|dwell| dwell.unit);
            return match unit {
                Some(DwellUnit::Revolutions) => {
                    untimed("A dwell in revolutions needs a spindle speed, and no S word in force says one.", None)
                }
                _ => untimed("The number of a dwell cannot be read.", None),
            };
        }
        match (control.feed, control.feed_unit) {
            (FeedCoding::Symbolic, _) => {
                untimed("A symbolic F has no value in the format.", Some("itemized.symbolicFeeds"))
            }
            (FeedCoding::TimeReciprocal, _) => untimed("No F word in force says a time.", None),
            (_, FeedUnit::PerRevolution) => {
                untimed("A feed per revolution needs a spindle speed, and no S word in force says one.", None)
            }
            _ => untimed("No F word in force says a feed; a thread needs its lead and a spindle speed.", None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::value::Positive;
    use crate::format::{Itemized, SetPoint, Standard};

    fn format() -> Format {
        Format::new(Standard::Iso2539, "N3.G2.X+42.F4.M2*")
    }

    #[test]
    fn what_is_known_of_the_machine_holds_on_under_another_reading() {
        let known = Format {
            itemized: Itemized {
                set_point: Some(SetPoint::InOrder(vec![10.0, 10.0])),
                rapid: Some(Positive(5000.0)),
                feed: Some(FeedCoding::Geometric),
                ..Itemized::default()
            },
            ..format()
        };
        let found = Format { itemized: Itemized { rapid: Some(Positive(9000.0)), ..Itemized::default() }, ..format() };
        let joined = found.on_machine_of(&known);
        assert_eq!(joined.itemized.set_point, None, "it is of the other tape");
        assert_eq!(joined.itemized.rapid, Some(Positive(9000.0)), "what it states itself goes before");
        assert_eq!(joined.itemized.feed, None, "how words are read is not of the machine");
        let inches = Format::new(Standard::Rs274, "n3 g2 x+14 f21 m2*").on_machine_of(&known);
        assert_eq!(inches.itemized.rapid, None, "5000 mm/min are not 5000 in/min");
    }

    #[test]
    fn a_span_without_a_time_says_which_field_would_give_it() {
        assert_eq!(format().why_untimed(SpanKind::Rapid).field, Some("itemized.rapid"));
        let symbolic =
            Format { itemized: Itemized { feed: Some(FeedCoding::Symbolic), ..Itemized::default() }, ..format() };
        assert_eq!(symbolic.why_untimed(SpanKind::Line).field, Some("itemized.symbolicFeeds"));
        assert_eq!(format().why_untimed(SpanKind::Line).field, None);
    }

    #[test]
    fn a_reader_draws_three_hundred_rows_a_second_unless_stated() {
        assert_eq!(format().reader_speed(), 300.0);
        let slow =
            Format { itemized: Itemized { reader_speed: Some(Positive(60.0)), ..Itemized::default() }, ..format() };
        assert_eq!(slow.reader_speed(), 60.0);
    }
}
