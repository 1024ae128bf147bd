//! Parabolas as blocks say them: in one block by tangent intersection point, slopes or focus, or in two by an
//! intermediate point (4.2.3).

use super::event::{Event, EventKind, Several};
use super::parabola::{Parabola, ParabolaFault};
use super::state::{Pending, State};
use crate::format::{ArcCentre, ParabolaParameters};
use crate::span::{Geometry, SpanKind};

impl State<'_> {
    /// A parabola in one block: 4.2.3.1.
    pub(super) fn parabola(&mut self) {
        self.finish_span();
        let start = self.position;
        let blocks = (self.block, self.block);
        let doubtful = self.is_doubtful(0..self.target.len());
        let (curve, degenerate) = match self.control.parabola_parameters {
            ParabolaParameters::Tangent => {
                let curve =
                    Parabola { start: self.point(&start), tangent: self.given_point(), end: self.point(&self.target) };
                (Ok(curve), ParabolaFault::Tangent)
            }
            ParabolaParameters::Slope => {
                // The slopes are I and J whatever the plane.
                self.note_idle(2, 6);
                (self.parabola_by_slopes(), ParabolaFault::SlopeOfChord)
            }
            ParabolaParameters::Focus => {
                let tolerance = (0..3).filter(|&index| self.parameters[index].is_some());
                let tolerance = tolerance.map(|index| self.parameter_step(index)).fold(self.coarsest(), f64::max);
                let (start, end) = (self.point(&start), self.point(&self.target));
                (Parabola::about(start, self.given_point(), end, tolerance), ParabolaFault::FocusOnLine)
            }
        };
        self.push_parabola(curve, &start, blocks, degenerate, doubtful);
    }

    /// The point that I, J and K give, as `arcCentre` says.
    fn given_point(&self) -> [f64; 3] {
        std::array::from_fn(|axis| {
            let reading = match self.reading(axis) {
                // Without a sign there is no quadrant of a parabola to choose: the plain difference.
                ArcCentre::Quadrant => ArcCentre::FromStart,
                other => other,
            };
            self.coordinate(axis, reading)
        })
    }

    /// I and J are the slopes at start and end, with as many decimals as their own designations state.
    fn parabola_by_slopes(&mut self) -> Result<Parabola, ParabolaFault> {
        let slope = |index: usize| self.parameter(index).ok_or(ParabolaFault::NoSlope(index));
        let (start, end) = (self.point(&self.position), self.point(&self.target));
        let axes = self.plane.axes();
        let curve = Parabola::by_slopes(start, end, axes, [slope(0)?, slope(1)?], self.coarsest())?;
        let first = axes[0];
        let (from, to) = (start[first].min(end[first]), start[first].max(end[first]));
        let turns_back = curve.tangent[first] <= from || curve.tangent[first] >= to;
        if turns_back && !self.is_doubtful(0..self.target.len()) {
            self.note(EventKind::TurnsBack);
        }
        Ok(curve)
    }

    /// A point of a parabola in two blocks: 4.2.3.2.
    pub(super) fn parabola_point(&mut self) {
        let Some(pending) = self.pending.take() else {
            let doubtful = self.is_doubtful(0..self.target.len());
            let (block, start, several) = (self.block, self.position, Several::Parabola);
            self.pending = Some(Pending { block, last: block, start, middle: None, several, doubtful });
            return;
        };
        let start = pending.start;
        let curve = Parabola::through(self.point(&start), self.point(&self.position), self.point(&self.target));
        let doubtful = pending.doubtful || self.is_doubtful(0..self.target.len());
        self.push_parabola(Ok(curve), &start, (pending.block, self.block), ParabolaFault::Intermediate, doubtful);
    }

    /// Adds a parabola, or its stand-in: `degenerate` is what is at fault where its tangent point lies on the chord.
    fn push_parabola(
        &mut self,
        curve: Result<Parabola, ParabolaFault>,
        start: &[i64],
        blocks: (usize, usize),
        degenerate: ParabolaFault,
        doubtful: bool,
    ) {
        if doubtful {
            self.leave_out(*start == *self.target);
            self.substitute(start, blocks.0);
            return;
        }
        let curve =
            curve.and_then(|curve| if curve.is_degenerate(self.coarsest()) { Err(degenerate) } else { Ok(curve) });
        let curve = match curve {
            Ok(curve) => curve,
            Err(fault) => {
                self.events.push(Event { block: blocks.0, kind: EventKind::Parabola(fault) });
                self.substitute(start, blocks.0);
                return;
            }
        };
        if degenerate == ParabolaFault::Intermediate && curve.is_skewed() {
            self.events.push(Event { block: blocks.0, kind: EventKind::Skewed });
        }
        let geometry = Geometry::Parabola { tangent: curve.tangent };
        self.push(SpanKind::Parabola, blocks, start, geometry, None);
    }

    /// The coarsest increment of X, Y and Z: what the rounding of the tape may put a point off by.
    fn coarsest(&self) -> f64 {
        let written = (0..3).filter(|&axis| self.control.axes[axis].sign.is_some());
        written.map(|axis| self.increment(axis)).fold(0.0, f64::max)
    }
}
