//! The tape writer: motions and functions become blocks of a format.
//!
//! The one place that knows how a format says a thing: order and digits of words, tabs, signs, dimensions, readings of
//! I, J and K, codings of feed and speed. What it is given comes from decimal G-code, from another tape, or from
//! elsewhere; what it cannot say is a [`Fault`], which the giver locates in its own source.

mod motion;
mod word;

pub(crate) use motion::{Course, Move, Pace};

use crate::format::{Control, Plane, System};
use crate::speed::{Coding, NoCode};

/// Why something cannot be said in a format.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Fault {
    /// The format has no word with this address.
    NoWord(char),
    /// A number has more digits than its word: address, number, how many digits it has before the decimal sign.
    TooLong { address: char, value: f64, before: u8 },
    /// A number below zero in a word without sign.
    Negative { address: char, value: f64 },
    /// The coding of F or S has no code for a speed.
    Speed { address: char, value: f64, why: NoCode },
    /// A feed per revolution where no speed is known, or a feed that is not known.
    NoFeed,
    /// The format's control has no arcs and parabolas.
    NoContouring,
    /// The third axis moves in an arc, and the format has no helix.
    Helix,
}

/// Writes blocks of a format.
pub(crate) struct TapeWriter<'a> {
    control: &'a Control,
    pub text: String,
    /// Where every axis stands, in least input increments.
    at: Vec<i64>,
    /// Every block written so far.
    blocks: i64,
    /// Comments for the next block.
    remarks: String,
    /// What the next blocks have before them: the optional block skip character.
    pub skip: bool,
    /// What is in force, as far as no block that may be skipped has said it.
    modal: Modal,
    /// The greatest difference between a number given and the one written, in least input increments.
    pub rounding: f64,
    /// Sequence numbers have begun anew.
    pub wrapped: bool,
}

#[derive(Clone, Default)]
struct Modal {
    motion: Option<u8>,
    plane: Option<Plane>,
    feed: Option<String>,
}

impl<'a> TapeWriter<'a> {
    /// Begins a tape: the program start character and the leading end of block.
    pub(crate) fn new(control: &'a Control) -> TapeWriter<'a> {
        TapeWriter {
            control,
            text: "%\n".to_owned(),
            at: control.set_point.clone(),
            blocks: 0,
            remarks: String::new(),
            skip: false,
            modal: Modal { plane: Some(control.plane), ..Modal::default() },
            rounding: 0.0,
            wrapped: false,
        }
    }

    /// Where an axis stands, in the unit of the format.
    pub(crate) fn position(&self, axis: usize) -> f64 {
        crate::execute::in_unit(&self.control.axes[axis], self.at[axis])
    }

    /// What has been said may have been skipped: all of it is to be said again.
    pub(crate) fn forget(&mut self) {
        self.modal = Modal::default();
    }

    /// A comment, which stands at the end of the next block. What the code of the tape lacks, or forbids in a comment, is
    /// a blank.
    pub(crate) fn comment(&mut self, text: &str) {
        let has = |c: char| !matches!(c, '(' | ')' | '%' | ':') && self.control.code.row(c).is_some();
        let cases = |c: char| [c, c.to_ascii_uppercase(), c.to_ascii_lowercase()].into_iter().find(|c| has(*c));
        let text: String = text.chars().map(|c| cases(c).unwrap_or(' ')).collect();
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        if !text.is_empty() {
            self.remarks.push_str(&format!(" ({text})"));
        }
    }

    /// A block with one function: M and two digits, or G.
    pub(crate) fn function(&mut self, address: char, code: u8) -> Result<(), Fault> {
        let word = self.code_word(address, i64::from(code))?;
        self.block(vec![(address, word)]);
        Ok(())
    }

    /// A block with a tool, a speed and a miscellaneous function, as far as they are given.
    pub(crate) fn functions(&mut self, tool: Option<i64>, speed: Option<f64>, code: Option<u8>) -> Result<(), Fault> {
        let mut words = Vec::new();
        if let Some(tool) = tool {
            let digits = self.control.format.itemized.compensation_digits.unwrap_or(0);
            let tool = tool.saturating_mul(10_i64.saturating_pow(u32::from(digits)));
            words.push(('T', self.code_word('T', tool)?));
        }
        if let Some(speed) = speed {
            words.push(('S', self.speed_word('S', speed, None)?));
        }
        if let Some(code) = code {
            words.push(('M', self.code_word('M', i64::from(code))?));
        }
        if !words.is_empty() {
            self.block(words);
        }
        Ok(())
    }

    /// Lets the tool dwell, by the word that the format has for it.
    pub(crate) fn dwell(&mut self, number: f64) -> Result<(), Fault> {
        let dwell = self.control.format.itemized.dwell.as_ref().ok_or(Fault::NoWord('G'))?;
        let word = self.plain_word(dwell.address, number)?;
        let preparatory = self.code_word('G', 4)?;
        self.block(vec![('G', preparatory), (dwell.address, word)]);
        Ok(())
    }

    /// Writes a block of words, at most one of each address, in the order of the detail.
    fn block(&mut self, mut words: Vec<(char, String)>) {
        self.blocks += 1;
        if let Some(designation) = self.control.designation(b'N') {
            let most = 10_i64.pow(u32::from(designation.width().clamp(1, 18))) - 1;
            self.wrapped |= self.blocks > most;
            let number = (self.blocks - 1) % most + 1;
            words.push(('N', format!("{number:0width$}", width = usize::from(designation.width()))));
        }
        if self.skip {
            self.text.push('/');
        }
        let columns = self.control.system == System::Tab;
        let (mut tabs, mut first) = (0, true);
        for designation in &self.control.detail.words {
            tabs += usize::from(designation.tab);
            let Some(place) = words.iter().position(|(address, _)| *address == designation.address) else { continue };
            let (address, word) = words.swap_remove(place);
            if tabs > 0 {
                self.text.extend(std::iter::repeat_n('\t', tabs));
            } else if !first {
                self.text.push(' ');
            }
            (tabs, first) = (0, false);
            if !columns {
                let lower = self.control.standard() == crate::Standard::Rs274;
                self.text.push(if lower { address.to_ascii_lowercase() } else { address });
            }
            self.text.push_str(&word);
        }
        self.text.push_str(&std::mem::take(&mut self.remarks));
        self.text.push('\n');
    }

    /// The word of a feed or a speed; `sweep` is that of an arc, in radians.
    fn speed_word(&self, address: char, value: f64, sweep: Option<f64>) -> Result<String, Fault> {
        let letter = address as u8;
        if self.control.designation(letter).is_none() {
            return Err(Fault::NoWord(address));
        }
        let value = if letter == b'F' { motion::rate(self.control, value, sweep) } else { value };
        let code = Coding::of(self.control, letter).encode(value);
        code.map(|code| code.to_string()).map_err(|why| Fault::Speed { address, value, why })
    }
}
