//! Lengths and times of a whole tape.

use crate::span::{Geometry, SpanKind, Spans};

/// Sums over all spans, added in their order.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals {
    /// Length cut at feed, in the unit of the format.
    pub cutting: f64,
    /// Length of rapid moves, in the unit of the format.
    pub rapid: f64,
    /// Time without the reader's; `None` if a moving span has no known time.
    pub seconds: Option<f64>,
}

impl Totals {
    pub(crate) fn of(spans: &Spans) -> Totals {
        let mut totals = Totals { seconds: Some(0.0), ..Totals::default() };
        for span in &spans.list {
            // What moves a rotary axis alone has no length along the path.
            let still = span.geometry == Geometry::Line && span.start == span.end;
            let length = if still { 0.0 } else { span.length };
            match span.kind {
                SpanKind::Rapid => totals.rapid += length,
                SpanKind::Dwell => {}
                _ => totals.cutting += length,
            }
            totals.seconds = totals.seconds.zip(span.seconds).map(|(sum, seconds)| sum + seconds);
        }
        totals.seconds = totals.seconds.filter(|seconds| seconds.is_finite());
        totals
    }
}
