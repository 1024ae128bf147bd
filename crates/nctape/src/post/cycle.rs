//! Cycles in long hand: every hole as the moves that it is made of.
//!
//! What G81 to G89 do on a control, and by which words, its builder says; a Format does not. In long hand a tape drills
//! the same holes on every control.

use super::motion::Rate;
use super::posting::Poster;
use crate::cldata::Key;
use crate::cldata::command::Argument;
use crate::cldata::execution::Per;
use crate::cldata::step::Step;
use crate::rules::posting as rules;
use std::ops::Range;

/// Whether points are holes.
#[derive(Clone, Debug)]
pub(super) enum CycleState {
    Off,
    On(Cycle),
    /// A cycle that cannot be posted: its points are left out until it is off.
    Refused,
}

/// A cycle. Lengths are in the unit of the format.
#[derive(Clone, Debug)]
pub(super) struct Cycle {
    kind: Kind,
    /// Below the point, positive.
    depth: f64,
    /// Above the point: to where the tool goes at rapid traverse, and to where it comes back.
    clear: f64,
    back: f64,
    feed: Option<(f64, Per)>,
    /// How much deeper each stroke goes.
    stroke: Option<f64>,
    /// At the bottom: a time in seconds.
    dwell: Option<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// In at feed, out at rapid traverse: G81, and with a dwell G82.
    Drill,
    /// In several strokes: G83.
    Deep,
    /// Out at feed with the spindle the other way: G84.
    Tap,
    /// Out at feed: G85, and with a dwell G89.
    Bore,
    /// Out at rapid traverse with the spindle stopped: G86.
    BoreAndStop,
}

impl Kind {
    fn of(word: &str) -> Option<Kind> {
        Some(match word {
            // Chips are broken where the tool is drawn out as well, whose way back nobody states otherwise.
            "DEEP" | "BRKCHP" => Kind::Deep,
            "DRILL" | "FACE" | "CSINK" | "CBORE" => Kind::Drill,
            "TAP" => Kind::Tap,
            // The number of a BORE is that of its G8x.
            "BORE" | "REAM" | "BORE5" | "BORE9" => Kind::Bore,
            "BORE6" => Kind::BoreAndStop,
            _ => return None,
        })
    }
}

/// Strokes of one hole at the most: more are a slip of the pen.
const MOST_STROKES: f64 = 1000.0;

impl Poster<'_> {
    /// CYCLE.
    pub(super) fn cycle(&mut self, step: &Step, arguments: &[Argument]) {
        let is = |word: &str| arguments == [Argument::Word(Key::of(word))];
        if is("OFF") {
            self.state.cycle = CycleState::Off;
            return;
        }
        let cycle = match (is("ON"), self.state.last_cycle.clone()) {
            (true, Some(last)) => Ok(last),
            (true, None) => Err("CYCLE,ON takes up the last cycle, and there was none.".to_owned()),
            _ => self.read_cycle(step, arguments),
        };
        self.state.cycle = match cycle {
            Ok(cycle) => {
                self.state.last_cycle = Some(cycle.clone());
                CycleState::On(cycle)
            }
            Err(message) => {
                let message = format!("{message} The points of this cycle are left out.");
                self.lack(&rules::command_not_posted::RULE, "", self.source.record(step.record), message);
                CycleState::Refused
            }
        };
    }

    fn read_cycle(&self, step: &Step, arguments: &[Argument]) -> Result<Cycle, String> {
        let named = match arguments.first() {
            Some(Argument::Word(key)) => key.word(),
            _ => String::new(),
        };
        let kind = Kind::of(&named).ok_or_else(|| format!("CYCLE,{named} is no cycle that is posted here."))?;
        let length = |value: f64| self.length(value * step.scale);
        let (mut depth, mut clear, mut rapid_to, mut back) = (None, None, None, None);
        let (mut feed, mut stroke, mut dwell) = (None, None, None);
        let mut at = 1;
        while at < arguments.len() {
            let word = match arguments[at] {
                Argument::Word(key) => key.word(),
                // Older systems write the depth right behind the kind, and the clearance as the next number alone.
                Argument::Number(value) if depth.is_none() => {
                    depth = Some(length(value));
                    at += 1;
                    continue;
                }
                Argument::Number(value) if clear.is_none() => {
                    clear = Some(length(value));
                    at += 1;
                    continue;
                }
                _ => return Err("What stands behind CYCLE cannot be read.".to_owned()),
            };
            let Some(Argument::Number(value)) = arguments.get(at + 1).copied() else {
                if word == "ON" {
                    at += 1;
                    continue;
                }
                return Err(format!("{word} has no number behind it that says how it changes this cycle."));
            };
            at += 2;
            match word.as_str() {
                "DEPTH" | "FEDTO" => depth = Some(length(value)),
                "CLEAR" => clear = Some(length(value)),
                "RAPTO" => rapid_to = Some(length(value)),
                "RETURN" | "RTRCTO" => back = Some(length(value)),
                "STEP" => stroke = Some(length(value)),
                "DWELL" => dwell = Some(value),
                "PERMIN" => feed = Some((length(value), Per::Minute)),
                "PERREV" => feed = Some((length(value), Per::Revolution)),
                "MMPM" => feed = Some((self.millimetres(value), Per::Minute)),
                "MMPR" => feed = Some((self.millimetres(value), Per::Revolution)),
                "IPM" => feed = Some((self.millimetres(value * 25.4), Per::Minute)),
                "IPR" => feed = Some((self.millimetres(value * 25.4), Per::Revolution)),
                _ => return Err(format!("{word} is nothing that a cycle here is made of.")),
            }
        }
        let depth = depth.ok_or("This cycle says no depth.")?;
        // Without a clearance the points are where rapid traverse ends, as older systems have them.
        let clear = rapid_to.or(clear).unwrap_or(0.0);
        let back = back.unwrap_or(clear);
        let stroke = match kind {
            Kind::Deep => Some(stroke.unwrap_or(depth)),
            _ => None,
        };
        let is_sound = depth > 0.0 && clear >= 0.0 && back >= 0.0;
        if !is_sound || stroke.is_some_and(|stroke| !(stroke > 0.0 && depth / stroke <= MOST_STROKES)) {
            return Err("Depth and strokes are above zero, and the tool comes out above the point.".to_owned());
        }
        Ok(Cycle { kind, depth, clear, back, feed, stroke, dwell })
    }

    /// Makes a hole at a point.
    pub(super) fn hole(&mut self, cycle: &Cycle, at: [f64; 3], rate: Rate, place: Range<usize>) {
        self.restart(&place);
        let rate = match cycle.feed {
            Some((feed, per)) => Rate { feed: Some(feed), per, ..rate },
            None => rate,
        };
        // A tool that fails on the way stays where it is: the rest of its hole would be cut from elsewhere.
        let _ = self.strokes(cycle, at, rate, place);
    }

    fn strokes(&mut self, cycle: &Cycle, at: [f64; 3], rate: Rate, place: Range<usize>) -> Option<()> {
        let height = |z: f64| [at[0], at[1], z];
        let done = |is_done: bool| is_done.then_some(());
        let (top, bottom, back) = (at[2] + cycle.clear, at[2] - cycle.depth, at[2] + cycle.back);
        let [x, y, z] = std::array::from_fn(|axis| self.writer.position(axis));
        // From hole to hole above the part.
        let over = f64::max(z, top);
        done(self.rapid([x, y, over], place.clone()))?;
        done(self.rapid(height(over), place.clone()))?;
        done(self.rapid(height(top), place.clone()))?;
        if let Some(stroke) = cycle.stroke {
            let mut reached = at[2];
            while reached - stroke > bottom {
                reached -= stroke;
                done(self.cut(height(reached), rate, place.clone()))?;
                done(self.rapid(height(top), place.clone()))?;
                // Above what is drilled as far as above the part.
                done(self.rapid(height(f64::min(reached + cycle.clear, top)), place.clone()))?;
            }
        }
        done(self.cut(height(bottom), rate, place.clone()))?;
        if let Some(seconds) = cycle.dwell {
            done(self.dwell(seconds, rate.speed, place.clone()))?;
        }
        match cycle.kind {
            Kind::Drill | Kind::Deep => done(self.rapid(height(back), place))?,
            Kind::Bore => done(self.cut(height(back), rate, place))?,
            Kind::Tap => {
                done(self.reverse(&place))?;
                done(self.cut(height(back), rate, place.clone()))?;
                done(self.reverse(&place))?;
            }
            Kind::BoreAndStop => {
                done(self.still(&place))?;
                done(self.rapid(height(back), place.clone()))?;
                self.restart(&place);
            }
        }
        Some(())
    }
}
