//! Lengths and times of a whole tape, and the room that its path takes.

use crate::span::{Span, SpanKind};

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

/// What one span adds to the totals, side by side with those of the others: after an edit they are all added again, so
/// that the sum does not hang on the way that led to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Share {
    cutting: f64,
    rapid: f64,
    /// Not a number where it is not known.
    seconds: f64,
}

impl Share {
    pub(crate) fn of(span: &Span) -> Share {
        let length = if span.angular { 0.0 } else { span.length };
        let (cutting, rapid) = match span.kind {
            SpanKind::Rapid => (0.0, length),
            SpanKind::Dwell => (0.0, 0.0),
            _ => (length, 0.0),
        };
        Share { cutting, rapid, seconds: span.seconds.unwrap_or(f64::NAN) }
    }
}

impl Totals {
    pub(crate) fn of(shares: &[Share]) -> Totals {
        let (mut cutting, mut rapid, mut seconds) = (0.0, 0.0, 0.0);
        for share in shares {
            cutting += share.cutting;
            rapid += share.rapid;
            seconds += share.seconds;
        }
        Totals { cutting, rapid, seconds: Some(seconds).filter(|seconds| seconds.is_finite()) }
    }
}

/// The smallest box around a path: least and greatest X, Y and Z in the unit of the format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least X, Y and Z.
    pub least: [f64; 3],
    /// The greatest X, Y and Z.
    pub greatest: [f64; 3],
}

impl Bounds {
    /// The box around spans; `None` around none.
    pub(crate) fn of(spans: &[Span]) -> Option<Bounds> {
        spans.iter().map(Span::bounds).map(|(least, greatest)| Bounds { least, greatest }).reduce(Bounds::with)
    }

    /// The box around both.
    pub(crate) fn with(self, other: Bounds) -> Bounds {
        Bounds {
            least: std::array::from_fn(|axis| f64::min(self.least[axis], other.least[axis])),
            greatest: std::array::from_fn(|axis| f64::max(self.greatest[axis], other.greatest[axis])),
        }
    }
}
