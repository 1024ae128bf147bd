//! What is said once of a whole tape that is written: numbers that were rounded, sequence numbers that begin anew.

use crate::diagnostic::{Severity, Sink};
use crate::rules::conversion as rules;
use crate::write::TapeWriter;
use std::ops::Range;

/// Where in the source each was met first.
#[derive(Default)]
pub(super) struct Noted {
    rounded: Option<Range<usize>>,
    speed: Option<Range<usize>>,
    wrapped: Option<Range<usize>>,
}

impl Noted {
    /// Looks at what the writer has done up to a piece of the source.
    pub(super) fn look(&mut self, writer: &TapeWriter<'_>, source: &Range<usize>) {
        let note = |place: &mut Option<Range<usize>>, met: bool| {
            if met && place.is_none() {
                *place = Some(source.clone());
            }
        };
        // A thousandth of an increment is what decimal fractions lose in binary.
        note(&mut self.rounded, writer.rounding > 1e-3);
        note(&mut self.speed, writer.speed_rounding > 1e-6);
        note(&mut self.wrapped, writer.wrapped);
    }

    /// Says it.
    pub(super) fn tell(self, writer: &TapeWriter<'_>, sink: &mut Sink<'_>) {
        if let Some(range) = self.rounded {
            let message = format!(
                "Numbers are rounded to the places of the format, by up to {:.2} of a least input increment.",
                writer.rounding
            );
            sink.report(&rules::rounded::RULE, range, message);
        }
        if let Some(range) = self.speed {
            // Two digits that say something, however small the share.
            let share = writer.speed_rounding * 100.0;
            let share = if share < 0.01 { "less than 0.01".to_owned() } else { format!("up to {share:.2}") };
            let message = format!("Feeds and speeds are written as the codes that the format has, {share} % off.");
            sink.report(&rules::rounded::RULE, range, message);
        }
        if let Some(range) = self.wrapped {
            let message = "The sequence numbers of the format are used up: from here on they begin anew, and one of them \
                           is not enough to find a block by. Give N more digits, or divide the tape.";
            sink.report_as(Severity::Warning, &rules::does_not_fit::RULE, range, message.to_owned());
        }
    }
}
