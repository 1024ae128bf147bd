//! What a rule sees of a text of CLDATA.

use crate::cldata::event::Noted;
use crate::cldata::execution::Execution;
use crate::cldata::record::{Record, Tables};
use std::ops::Range;

/// A text of CLDATA, read and carried out. Places are bytes of its stream.
pub(crate) struct CldataView<'a> {
    pub text: &'a str,
    pub tables: &'a Tables,
    pub execution: &'a Execution,
}

impl<'a> CldataView<'a> {
    /// The text at a place.
    pub fn at(&self, range: &Range<usize>) -> &'a str {
        &self.text[range.clone()]
    }

    /// Where a record is.
    pub fn place(&self, record: &Record) -> Range<usize> {
        record.range()
    }

    /// Where an event is.
    pub fn event(&self, found: &Noted) -> Range<usize> {
        found.range(self.tables)
    }

    /// The number of a record, and where it stands.
    pub fn number(&self, record: &Record) -> Option<(i64, Range<usize>)> {
        let first = self.tables.of(record).first()?;
        first.whole().map(|number| (number, first.range()))
    }
}
