//! The feed of a thread (G33): the tool goes on by the lead with every revolution of the spindle.

use super::event::EventKind;
use super::feed::Feed;
use super::state::{Motion, State};
use crate::format::{Standard, Unit};
use crate::read::number;

impl State<'_> {
    /// Takes the leads of a thread block. Where it gives none, those before it hold on (3.2.3).
    pub(super) fn take_leads(&mut self) {
        if self.parameters.iter().any(Option::is_some) {
            self.leads = self.parameters.map(|parameter| parameter.map_or(0, |parameter| parameter.value));
        }
    }

    /// Notes a thread that has no lead along the axes that move, and a lead of this block along one that does not.
    pub(super) fn check_leads(&mut self, start: &[i64]) {
        if self.control.standard() == Standard::Iso1058 {
            return;
        }
        let moves: [bool; 3] = std::array::from_fn(|axis| self.target[axis] != start[axis]);
        for axis in (0..3).filter(|&axis| !moves[axis]) {
            if let Some(parameter) = self.parameters[axis].filter(|parameter| parameter.value != 0) {
                self.note(EventKind::IdleLead { word: parameter.place, axis });
            }
        }
        let has_lead = (0..3).any(|axis| moves[axis] && self.leads[axis] != 0);
        let by_feed = self.leads == [0; 3] && matches!(self.feed, Feed::PerRevolution(_) | Feed::Unknown);
        if moves.contains(&true) && !has_lead && !by_feed {
            let axis = (0..3).filter(|&axis| moves[axis]).max_by_key(|&axis| self.target[axis].abs_diff(start[axis]));
            self.note(EventKind::NoLead { axis: axis.unwrap_or(2) });
        }
    }

    /// The leads along X, Y and Z in the unit of the format, while a thread function is in force.
    pub(super) fn leads_in_force(&self) -> Option<[f64; 3]> {
        let lead = |axis: usize| number::in_unit(self.control, b"IJK"[axis], self.leads[axis]);
        self.is_thread().then(|| std::array::from_fn(lead))
    }

    /// The path is a thread.
    pub(super) fn is_thread(&self) -> bool {
        matches!(self.motion, Some(Motion::Thread { .. }))
    }

    /// Minutes for a thread of a length from one position to the target: its revolutions over the spindle speed.
    pub(super) fn thread_minutes(&self, start: &[i64], length: f64) -> Option<f64> {
        let speed = self.speed.filter(|speed| *speed > 0.0)?;
        Some(self.thread_turns(start, length)? / speed)
    }

    /// Revolutions for a thread of a length from one position to the target. Each of I, J and K is the lead along X, Y
    /// and Z; where several are given the axis that needs most revolutions says how many, so that none exceeds its lead.
    /// Under G34 and G35 the lead changes by an amount that the builder states somewhere else, and they are not known.
    pub(super) fn thread_turns(&self, start: &[i64], length: f64) -> Option<f64> {
        if self.motion != Some(Motion::Thread { constant: true }) {
            return None;
        }
        let turns_of = |axis: usize| {
            let lead = number::in_unit(self.control, b"IJK"[axis], self.leads[axis]).abs();
            let way = (self.in_unit(axis, self.target[axis]) - self.in_unit(axis, start[axis])).abs();
            (lead > 0.0 && way > 0.0).then(|| way / lead)
        };
        let by_leads = (0..3).filter_map(turns_of).reduce(f64::max);
        by_leads.or_else(|| self.turns_by_feed(length).filter(|_| self.leads == [0; 3]))
    }

    /// The revolutions of a thread whose lead stands in F. ISO 1058 has no I, J and K, and counts F in millimetres per
    /// revolution, or in revolutions per inch (A.1.2.1); elsewhere a feed per revolution is one along the path.
    fn turns_by_feed(&self, length: f64) -> Option<f64> {
        let positioning = self.control.standard() == Standard::Iso1058;
        let feed = match self.feed {
            Feed::PerRevolution(feed) => feed,
            Feed::PerMinute(number) if positioning => number,
            _ => return None,
        };
        if feed <= 0.0 {
            return None;
        }
        Some(if positioning && self.control.unit == Unit::Inch { length * feed } else { length / feed })
    }
}
