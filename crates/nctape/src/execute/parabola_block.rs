//! Parabolas as blocks say them: in one block by the tangent intersection point, or in two by an intermediate point
//! (4.2.3).

use super::event::{Event, EventKind, ParameterReading};
use super::parabola::Parabola;
use super::state::{Pending, State};
use crate::format::{ArcCentre, ParabolaParameters};
use crate::span::{Geometry, SpanKind};

impl State<'_> {
    /// A parabola in one block: 4.2.3.1.
    pub(super) fn parabola(&mut self) {
        self.finish_span();
        let start = self.position;
        if self.control.parabola_parameters != ParabolaParameters::Tangent {
            let reading = match self.control.parabola_parameters {
                ParabolaParameters::Focus => ParameterReading::Focus,
                _ => ParameterReading::Slope,
            };
            self.refuse(reading, &start);
            return;
        }
        let tangent = std::array::from_fn(|axis| {
            let reading = match self.reading(axis) {
                // Without a sign there is no quadrant of a parabola to choose: the plain difference.
                ArcCentre::Quadrant => ArcCentre::FromStart,
                other => other,
            };
            self.coordinate(axis, reading)
        });
        let curve = Parabola { start: self.point(&start), tangent, end: self.point(&self.target) };
        let doubtful = self.is_doubtful(0..self.target.len());
        self.push_parabola(curve, &start, (self.block, self.block), false, doubtful);
    }

    /// A point of a parabola in two blocks: 4.2.3.2.
    pub(super) fn parabola_point(&mut self) {
        let Some(pending) = self.pending.take() else {
            let doubtful = self.is_doubtful(0..self.target.len());
            self.pending = Some(Pending { block: self.block, start: self.position, parabola: true, doubtful });
            return;
        };
        let start = pending.start;
        let curve = Parabola::through(self.point(&start), self.point(&self.position), self.point(&self.target));
        let doubtful = pending.doubtful || self.is_doubtful(0..self.target.len());
        self.push_parabola(curve, &start, (pending.block, self.block), true, doubtful);
    }

    fn push_parabola(
        &mut self,
        curve: Parabola,
        start: &[i64],
        blocks: (usize, usize),
        intermediate: bool,
        doubtful: bool,
    ) {
        if doubtful {
            self.leave_out(*start == *self.target);
            self.substitute(start, blocks.0);
            return;
        }
        let increment = (0..3).filter(|&axis| self.control.axes[axis].sign.is_some());
        let increment = increment.map(|axis| self.increment(axis)).fold(0.0, f64::max);
        let degenerate = curve.is_degenerate(increment);
        let kind = match degenerate {
            true => Some(EventKind::Degenerate { intermediate }),
            false => (intermediate && curve.is_skewed()).then_some(EventKind::Skewed),
        };
        if let Some(kind) = kind {
            self.events.push(Event { block: blocks.0, kind });
        }
        if degenerate {
            self.substitute(start, blocks.0);
            return;
        }
        let geometry = Geometry::Parabola { tangent: curve.tangent };
        self.push(SpanKind::Parabola, blocks, start, geometry, None);
    }
}
