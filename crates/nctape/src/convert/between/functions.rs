//! Tools, speeds and functions: ISO 1056 gives their numbers one meaning in every format.

use super::Writer;
use crate::execute::Followed as Step;
use crate::function::{Group, Miscellaneous, Preparatory, Start, miscellaneous, preparatory};
use crate::read::Word;
use crate::rules::Rule;
use crate::rules::conversion as rules;

/// Metres in a foot: cutting speeds are metres or feet per minute, where lengths are millimetres or inches.
const FOOT: f64 = 0.3048;

impl Writer<'_> {
    /// The preparatory functions of the block that stand by themselves. Those of motions, planes, dimensions and kinds of
    /// feed are written as what they do.
    pub(super) fn preparatory(&mut self, step: &Step<'_>) {
        for word in step.words.iter().filter(|word| word.address == b'G') {
            let Some(code) = word.function(b'G') else {
                self.leave_out(step, word, &rules::word_left_out::RULE);
                continue;
            };
            let written = match preparatory(code) {
                Preparatory::Assigned(Group::Motion, _) => {
                    if let 33..=35 = code {
                        self.thread = code;
                    }
                    continue;
                }
                Preparatory::Assigned(Group::Plane | Group::Dimensions | Group::Feed, _) => continue,
                Preparatory::Assigned(Group::Once, _) if matches!(code, 4 | 92) => continue,
                Preparatory::Assigned(Group::Once, _) => self.out.once(code),
                Preparatory::Assigned(group, _) => {
                    if group == Group::Spindle {
                        self.cutting_speed = code == 96;
                    }
                    self.out.function('G', code)
                }
                _ if self.tape.control().is_curve(code) => continue,
                _ if self.means_the_same('G', code) => self.out.function('G', code),
                _ => {
                    self.leave_out(step, word, &rules::function_left_out::RULE);
                    continue;
                }
            };
            self.take(written, self.tape.reading().range(step.block, word));
        }
    }

    /// Both formats declare a function that ISO 1056 leaves to the builder, and alike.
    fn means_the_same(&self, address: char, code: u8) -> bool {
        let name = format!("{address}{code:02}");
        let [own, other] = [&self.tape.control().format, &self.to.format].map(|format| {
            let declared = format.itemized.declared.as_ref()?;
            if address == 'G' { declared.g.get(&name) } else { declared.m.get(&name) }
        });
        own.is_some() && own == other
    }

    /// The words that go with the motion of the block, into its block: tool, speed, and a miscellaneous function that acts
    /// with it; and what has no meaning beyond its address.
    pub(super) fn hold(&mut self, step: &Step<'_>) {
        let (from, to) = (self.tape.control(), self.to);
        let dwell = from.format.itemized.dwell.as_ref().filter(|_| is_dwell(step)).map(|dwell| dwell.address);
        for word in step.words {
            let letter = word.letter();
            let held = match word.address {
                _ if dwell == Some(letter) => continue,
                b'N' | b':' | b'G' | b'F' | b'I' | b'J' | b'K' => continue,
                b'T' => match self.tool(word) {
                    Some(tool) => self.out.code_word('T', tool),
                    None => {
                        self.leave_out(step, word, &rules::word_left_out::RULE);
                        continue;
                    }
                },
                b'S' => match self.speed(word) {
                    Some(speed) => self.out.spindle(speed),
                    None => {
                        self.leave_out(step, word, &rules::word_left_out::RULE);
                        continue;
                    }
                },
                b'M' => match word.function(b'M') {
                    Some(code) if acts_behind(code) => continue,
                    Some(code) if self.is_known(code) => self.out.code_word('M', code.into()),
                    _ => {
                        self.leave_out(step, word, &rules::function_left_out::RULE);
                        continue;
                    }
                },
                // The vector of compensation has no unit.
                b'P'..=b'R' if from.vectors && to.vectors => match self.tape.value(word) {
                    Some(value) => self.out.plain_word(letter, value),
                    None => continue,
                },
                address if from.axis(address).is_some() => continue,
                address => match (word.value, to.designation(address).filter(|other| !other.dimension)) {
                    (Some(number), Some(_)) => self.out.code_word(letter, number),
                    _ => {
                        self.leave_out(step, word, &rules::word_left_out::RULE);
                        continue;
                    }
                },
            };
            match held {
                Ok(text) => self.out.hold(letter, text),
                Err(fault) => self.take(Err(fault), self.tape.reading().range(step.block, word)),
            }
        }
    }

    /// The miscellaneous functions that act after the motion, behind what was written from byte `from` on.
    pub(super) fn behind(&mut self, step: &Step<'_>, from: usize) {
        for word in step.words {
            let Some(code) = word.function(b'M').filter(|code| acts_behind(*code)) else { continue };
            match self.out.code_word('M', code.into()) {
                Ok(text) => self.out.append('M', text, from),
                Err(fault) => self.take(Err(fault), self.tape.reading().range(step.block, word)),
            }
        }
    }

    fn is_known(&self, code: u8) -> bool {
        matches!(miscellaneous(code), Miscellaneous::Assigned(..)) || self.means_the_same('M', code)
    }

    /// The number of a T word, with as many digits of the compensation as the other format has.
    fn tool(&self, word: &Word) -> Option<i64> {
        let power = |digits: Option<u8>| 10_i64.checked_pow(u32::from(digits.unwrap_or(0)));
        let own = power(self.tape.control().format.itemized.compensation_digits)?;
        let other = power(self.to.format.itemized.compensation_digits)?;
        let (tool, compensation) = (word.value? / own, word.value? % own);
        // The first compensation of a tool may go without saying; another may not.
        if compensation >= other && compensation != 0 {
            return None;
        }
        tool.checked_mul(other)?.checked_add(compensation)
    }

    fn speed(&self, word: &Word) -> Option<f64> {
        let speed = self.follow.spindle_number(word)?;
        let inches = self.scale[0];
        Some(match self.cutting_speed {
            true if inches > 1.0 => speed * FOOT,
            true if inches < 1.0 => speed / FOOT,
            _ => speed,
        })
    }

    /// Says that a word is not on the tape that is written, and marks the place there.
    pub(super) fn leave_out(&mut self, step: &Step<'_>, word: &Word, rule: &'static Rule) {
        let range = self.tape.reading().range(step.block, word);
        let written = &self.tape.text()[range.clone()];
        let message = format!(
            "{written} is left out: the other format has no such word or function, or the tape does not say its number. \
             What it does on the machine is to be put in by hand, where the tape says LEFT OUT."
        );
        self.out.comment(&format!("LEFT OUT {written}"));
        self.report(rule, range, message);
    }
}

/// The block lets the tool dwell.
pub(super) fn is_dwell(step: &Step<'_>) -> bool {
    step.words.iter().any(|word| word.function(b'G') == Some(4))
}

/// The function acts after the motion of its block.
fn acts_behind(code: u8) -> bool {
    matches!(miscellaneous(code), Miscellaneous::Assigned(_, Start::After, ..))
}
