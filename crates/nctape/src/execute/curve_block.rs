//! Curves of higher order as blocks say them: a cubic in three blocks under a declared G code (4.2.4).

use super::cubic::Cubic;
use super::event::{EventKind, Several};
use super::state::{Pending, State};
use crate::span::{Geometry, SpanKind};

impl State<'_> {
    /// A point of a cubic: two intermediate points and the end; the next cubic begins there.
    pub(super) fn curve_point(&mut self, code: u8) {
        (0..3).for_each(|index| self.note_idle(index, code));
        if !self.addressed {
            return;
        }
        let doubtful = self.is_doubtful(0..self.target.len());
        let (start, block, doubtful, middle) = match self.pending.take() {
            Some(Pending { start, block, doubtful: before, middle, .. }) => {
                (start, block, before || doubtful, Some(middle))
            }
            None => (self.position, self.block, doubtful, None),
        };
        // The tool stands on the first point when the second is read, and on the second when the third is.
        let middle = match middle {
            Some(Some(middle)) => middle,
            other => {
                let middle = other.map(|_| self.position);
                self.pending =
                    Some(Pending { block, last: self.block, start, middle, several: Several::Curve, doubtful });
                return;
            }
        };
        let still = middle[..3] == start[..3] && self.position[..3] == start[..3] && self.target[..3] == start[..3];
        if doubtful {
            self.leave_out(self.target == start);
            self.substitute(&start, block);
        } else if still && self.target == start {
            self.note(EventKind::NoMotion);
        } else if still {
            self.push(SpanKind::Curve, (block, self.block), &start, Geometry::Line, None);
        } else {
            let points = [start, middle, self.position, self.target].map(|position| self.point(&position));
            let geometry = Geometry::Curve { control: Cubic::through(points).control };
            self.push(SpanKind::Curve, (block, self.block), &start, geometry, None);
        }
    }
}
