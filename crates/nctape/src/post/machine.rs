//! Spindle, coolant, tools and cutter compensation.

use super::posting::Poster;
use crate::cldata::Key;
use crate::cldata::command::Argument;
use crate::cldata::step::Step;
use crate::format::{DwellUnit, Plane};
use crate::rules::posting as rules;
use std::ops::Range;

/// What runs at the machine.
#[derive(Clone, Debug, Default)]
pub(super) struct Machine {
    /// Revolutions per minute, as last said.
    speed: Option<f64>,
    /// The sense of rotation, as last said: M03 or M04.
    sense: Option<u8>,
    /// The spindle is to turn; the tape has it turn, by which speed and sense.
    turns: bool,
    turning: Option<(f64, u8)>,
    /// The coolant that was last on: M07 or M08; whether it is to be on; what the tape has on.
    coolant: Option<u8>,
    cools: bool,
    cooling: Option<u8>,
    /// The compensation that was last on: G41 or G42.
    compensation: Option<u8>,
}

impl Machine {
    /// M00 and M01 stop the spindle and the coolant (ISO 1056).
    pub(super) fn stopped(&mut self) {
        (self.turning, self.cooling) = (None, None);
    }
}

impl Poster<'_> {
    /// SPINDL.
    pub(super) fn spindle(&mut self, step: &Step, arguments: &[Argument]) {
        let place = self.source.record(step.record);
        let has = |word: &str| arguments.contains(&Argument::Word(Key::of(word)));
        if has("SFM") || has("SMM") {
            let message = "A cutting speed has the control change the spindle speed with the diameter, which this \
                           post-processor does not ask of it: state revolutions per minute.";
            self.lack(&rules::command_not_posted::RULE, "", place, message.to_owned());
            return;
        }
        let mut at = 0;
        while at < arguments.len() {
            match arguments[at] {
                Argument::Number(speed) => self.state.machine.speed = Some(speed.abs()),
                Argument::Word(key) => match key.word().as_str() {
                    "CLW" => self.state.machine.sense = Some(3),
                    "CCLW" => self.state.machine.sense = Some(4),
                    "ON" | "OFF" | "ORIENT" | "RPM" => {}
                    word => {
                        self.left_out("SPINDL", word, &place);
                        // What it is followed by is its own.
                        let is_own = matches!(word, "RANGE" | "MAXRPM");
                        at += usize::from(is_own && at + 1 < arguments.len());
                    }
                },
                Argument::Other => self.left_out("SPINDL", "a text", &place),
            }
            at += 1;
        }
        if has("OFF") {
            self.state.machine.turns = false;
            self.still(&place);
        } else if has("ORIENT") {
            self.state.machine.turns = false;
            self.state.machine.turning = None;
            let written = self.writer.function('M', 19);
            self.take(written, place);
        } else if self.state.machine.speed.is_none() {
            let message = "The spindle is to turn, and nothing has said how fast.";
            self.lack(&rules::command_not_posted::RULE, "", place, message.to_owned());
        } else {
            self.state.machine.turns = true;
            self.turn(&place);
        }
    }

    /// Has the spindle turn as it was last said, where it does not.
    fn turn(&mut self, place: &Range<usize>) -> bool {
        let Some(speed) = self.state.machine.speed else { return true };
        // Clockwise until something else is said, as a drill or a cutter goes.
        let wanted = (speed, self.state.machine.sense.unwrap_or(3));
        if self.state.machine.turning == Some(wanted) {
            return true;
        }
        let known = self.state.machine.turning.filter(|(running, _)| *running == speed);
        let written = self.writer.functions(None, Some(speed).filter(|_| known.is_none()), Some(wanted.1));
        self.state.machine.turning = Some(wanted);
        self.take(written, place.clone())
    }

    /// Stops the spindle.
    pub(super) fn still(&mut self, place: &Range<usize>) -> bool {
        self.state.machine.turning = None;
        let written = self.writer.function('M', 5);
        self.take(written, place.clone())
    }

    /// The spindle turns the other way; again, and it turns as before.
    pub(super) fn reverse(&mut self, place: &Range<usize>) -> bool {
        let Some((speed, sense)) = self.state.machine.turning else {
            let message = "A tap is drawn out with the spindle the other way round, and it does not turn.";
            self.lack(&rules::command_not_posted::RULE, "", place.clone(), message.to_owned());
            return false;
        };
        let other = 7 - sense;
        self.state.machine.turning = Some((speed, other));
        let written = self.writer.function('M', other);
        self.take(written, place.clone())
    }

    /// What a stop has stopped goes on before the next motion.
    pub(super) fn restart(&mut self, place: &Range<usize>) {
        if self.state.machine.turns && self.state.machine.turning.is_none() {
            self.turn(place);
        }
        if self.state.machine.cools && self.state.machine.cooling.is_none() {
            self.cool(place);
        }
    }

    /// COOLNT.
    pub(super) fn coolant(&mut self, step: &Step, arguments: &[Argument]) {
        let place = self.source.record(step.record);
        let words: Vec<String> = arguments
            .iter()
            .map(|argument| if let Argument::Word(key) = argument { key.word() } else { "a number".to_owned() })
            .collect();
        match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            ["OFF"] => {
                self.state.machine.cools = false;
                if self.state.machine.cooling.take().is_some() || self.state.machine.coolant.is_none() {
                    let written = self.writer.function('M', 9);
                    self.take(written, place);
                }
                return;
            }
            ["FLOOD"] => self.state.machine.coolant = Some(8),
            ["MIST"] => self.state.machine.coolant = Some(7),
            ["ON"] => {}
            _ => {
                let message = format!(
                    "COOLNT,{} is no coolant that ISO 1056 knows: MIST, FLOOD, ON and OFF are.",
                    words.join(",")
                );
                self.lack(&rules::command_not_posted::RULE, "", place, message);
                return;
            }
        }
        self.state.machine.cools = true;
        self.cool(&place);
    }

    /// The last coolant; flood where none was named.
    fn cool(&mut self, place: &Range<usize>) {
        let code = self.state.machine.coolant.unwrap_or(8);
        if self.state.machine.cooling.replace(code) != Some(code) {
            let written = self.writer.function('M', code);
            self.take(written, place.clone());
        }
    }

    /// LOADTL, which changes the tool; SELCTL, TOOLNO and TURRET, which choose it.
    pub(super) fn tool(&mut self, step: &Step, word: &str, arguments: &[Argument]) {
        let place = self.source.record(step.record);
        let number = match arguments.first() {
            Some(Argument::Number(number)) if number.fract() == 0.0 && (0.0..1e9).contains(number) => *number as i64,
            _ => {
                let message = format!("{word} wants the number of a tool, a whole one.");
                self.lack(&rules::command_not_posted::RULE, "", place, message);
                return;
            }
        };
        for argument in &arguments[1..] {
            if let Argument::Word(key) = argument {
                self.left_out(word, &key.word(), &place);
            }
        }
        let change = (word == "LOADTL").then_some(6);
        let written = self.writer.functions(Some(number), None, change);
        self.take(written, place);
    }

    /// CUTCOM.
    pub(super) fn compensation(&mut self, step: &Step, arguments: &[Argument]) {
        let place = self.source.record(step.record);
        let (mut code, mut register, mut at) = (None, None, 0);
        while at < arguments.len() {
            let word = if let Argument::Word(key) = arguments[at] { key.word() } else { String::new() };
            match word.as_str() {
                "LEFT" => code = Some(41),
                "RIGHT" => code = Some(42),
                "OFF" => code = Some(40),
                "ON" => code = self.state.machine.compensation,
                "XYPLAN" | "ZXPLAN" | "YZPLAN" => {
                    let plane = match word.as_str() {
                        "XYPLAN" => Plane::Xy,
                        "ZXPLAN" => Plane::Zx,
                        _ => Plane::Yz,
                    };
                    let written = self.writer.turn(plane);
                    self.take(written, place.clone());
                }
                "ADJUST" => {
                    at += 1;
                    register = match arguments.get(at) {
                        Some(Argument::Number(number)) if (0.0..1e9).contains(number) => Some(*number as i64),
                        _ => None,
                    };
                }
                word => self.left_out("CUTCOM", if word.is_empty() { "a number" } else { word }, &place),
            }
            at += 1;
        }
        let Some(code) = code else {
            let message = "CUTCOM says neither LEFT, RIGHT nor OFF.";
            self.lack(&rules::command_not_posted::RULE, "", place, message.to_owned());
            return;
        };
        if code != 40 {
            self.state.machine.compensation = Some(code);
        }
        let is_dimension = self.control.designation(b'D').is_none_or(|word| word.dimension);
        let written = match register {
            Some(register) if !is_dimension => self.writer.function_with('G', code, ('D', register)),
            Some(_) => {
                self.left_out("CUTCOM", "ADJUST", &place);
                self.writer.function('G', code)
            }
            None => self.writer.function('G', code),
        };
        self.take(written, place);
    }

    /// Lets the tool dwell for a time in seconds.
    pub(super) fn dwell(&mut self, seconds: f64, speed: Option<f64>, place: Range<usize>) -> bool {
        let unit = self.control.format.itemized.dwell.as_ref().map(|dwell| dwell.unit);
        let count = match (unit, speed) {
            (Some(DwellUnit::Revolutions), Some(speed)) => seconds * speed / 60.0,
            (Some(DwellUnit::Revolutions), None) => {
                let message = "The format counts a dwell in revolutions, and no spindle speed is known.";
                self.lack(&rules::command_not_posted::RULE, "", place, message.to_owned());
                return false;
            }
            _ => seconds,
        };
        let written = self.writer.dwell(count);
        self.take(written, place)
    }

    /// DELAY: seconds, or revolutions.
    pub(super) fn delay(&mut self, step: &Step, arguments: &[Argument]) {
        let place = self.source.record(step.record);
        let number = arguments.iter().find_map(|argument| match argument {
            Argument::Number(number) if *number >= 0.0 => Some(*number),
            _ => None,
        });
        let by_revolutions = arguments.contains(&Argument::Word(Key::of("REV")));
        let speed = self.state.machine.speed.filter(|speed| *speed > 0.0);
        let seconds = match (number, by_revolutions, speed) {
            (Some(seconds), false, _) => seconds,
            (Some(revolutions), true, Some(speed)) => revolutions * 60.0 / speed,
            _ => {
                let message = "DELAY wants a time in seconds, or revolutions of a spindle whose speed is known.";
                self.lack(&rules::command_not_posted::RULE, "", place, message.to_owned());
                return;
            }
        };
        self.dwell(seconds, speed, place);
    }

    /// Says that a part of a command is left out.
    pub(super) fn left_out(&mut self, command: &str, part: &str, place: &Range<usize>) {
        let message = format!("{part} of {command} is left out: no word of a tape says it. See to it at the machine.");
        self.report(&rules::part_left_out::RULE, "", place.clone(), message);
    }
}
