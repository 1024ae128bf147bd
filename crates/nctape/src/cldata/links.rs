//! From a place of the text to its record, its element and its span, and back.

use super::{Cldata, Element, type_name};
use std::ops::Range;

impl Cldata {
    /// The record at a byte of the text, its separator and the place behind that included.
    pub fn record_at(&self, byte: usize) -> Option<usize> {
        let record = self.records().partition_point(|record| self.record_range(record).start <= byte).checked_sub(1)?;
        (byte <= self.record_range(&self.records()[record]).end).then_some(record)
    }

    /// The spans that a record belongs to.
    pub fn spans_of(&self, record: usize) -> Range<usize> {
        self.spans().of_block(record)
    }

    /// The span at a byte of a record: the one that ends in the point there, or in the first point behind it.
    pub fn span_at(&self, record: usize, byte: usize) -> Option<usize> {
        let spans = self.spans_of(record);
        if spans.is_empty() {
            return None;
        }
        let found = self.records().get(record)?;
        let before = self.elements(found).partition_point(|element| self.element_range(element).start <= byte);
        let element = found.elements().start + before.saturating_sub(1);
        let ends = &self.execution.ends[spans.clone()];
        // A point has three elements, or six with its tool axis: the last one that begins here or before.
        let at = ends.partition_point(|end| *end as usize <= element).saturating_sub(1);
        Some(spans.start + at)
    }

    /// The first element of the point that a span ends in.
    pub fn end_of_span(&self, span: usize) -> Option<&Element> {
        let element = *self.execution.ends.get(span)?;
        self.tables.elements.get(element as usize)
    }

    /// Whether a record is kept, and nothing is made of it.
    pub fn is_kept(&self, record: usize) -> bool {
        let kind = self.records().get(record).map_or(0, |record| record.kind);
        type_name(kind).is_none() || self.execution.kept.binary_search(&(record as u32)).is_ok()
    }
}
