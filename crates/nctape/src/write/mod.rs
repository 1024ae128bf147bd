//! The tape writer: motions and functions become blocks of a format.
//!
//! The one place that knows how a format says a thing: order and digits of words, tabs, signs, dimensions, readings of
//! I, J and K, codings of feed and speed. What it is given comes from decimal G-code, from another tape, or from
//! elsewhere; what it cannot say is a [`Fault`], which the giver locates in its own source.

mod block;
mod curve;
mod fault;
mod feed;
mod motion;
mod word;

pub(crate) use fault::Fault;
pub(crate) use feed::Pace;
pub(crate) use motion::{Course, Move};

use crate::format::{Control, Plane};
use block::Last;

/// Writes blocks of a format.
pub(crate) struct TapeWriter<'a> {
    control: &'a Control,
    pub text: String,
    /// Where every axis stands, in least input increments.
    at: Vec<i64>,
    /// The sequence numbers of the blocks that follow.
    pub numbering: Numbering,
    /// Comments for the next block.
    remarks: String,
    /// Words for the next block.
    held: Vec<(char, String)>,
    /// The next block is one at which a machine may begin: its sequence number has the alignment character.
    align: bool,
    /// A preparatory function that acts in the block of the next motion alone.
    once: Option<u8>,
    /// The block written last.
    last: Option<Last>,
    /// What the next blocks have before them: the optional block skip character.
    pub skip: bool,
    /// Arcs are cut at the axes of their circle, whatever the reading of I, J and K.
    pub quadrants: bool,
    /// What is in force, as far as no block that may be skipped has said it.
    modal: Modal,
    /// A block has said what kind a feed is (G94, G95).
    changes_feed_kind: bool,
    /// The greatest difference between a number given and the one written, in least input increments.
    pub rounding: f64,
    /// The greatest share by which a feed or a speed differs from the one given.
    pub speed_rounding: f64,
    /// Sequence numbers have begun anew.
    pub wrapped: bool,
}

/// Sequence numbers: the next one, by how much they grow, the one with which they begin anew where the word has no more
/// digits; and whether blocks get any.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numbering {
    pub next: i64,
    pub step: i64,
    pub first: i64,
    pub on: bool,
}

impl Default for Numbering {
    fn default() -> Numbering {
        Numbering { next: 1, step: 1, first: 1, on: true }
    }
}

#[derive(Clone, Default)]
struct Modal {
    motion: Option<u8>,
    plane: Option<Plane>,
    feed: Option<String>,
    /// G94 or G95, where it is not the kind of feed that the format itself has.
    feed_kind: Option<u8>,
}

impl<'a> TapeWriter<'a> {
    /// Begins a tape: the program start character and the leading end of block.
    pub(crate) fn new(control: &'a Control) -> TapeWriter<'a> {
        TapeWriter {
            control,
            text: "%\n".to_owned(),
            at: control.set_point.clone(),
            numbering: Numbering::default(),
            remarks: String::new(),
            held: Vec::new(),
            align: false,
            once: None,
            last: None,
            skip: false,
            quadrants: false,
            modal: Modal::start(control),
            changes_feed_kind: false,
            rounding: 0.0,
            speed_rounding: 0.0,
            wrapped: false,
        }
    }

    /// Where an axis stands, in the unit of the format.
    pub(crate) fn position(&self, axis: usize) -> f64 {
        crate::execute::in_unit(&self.control.axes[axis], self.at[axis])
    }

    /// What has been said may have been skipped: all of it is to be said again.
    pub(crate) fn forget(&mut self) {
        let kind = self.control.own_feed_kind();
        self.modal = Modal { feed_kind: (!self.changes_feed_kind).then_some(kind), ..Modal::default() };
    }

    /// Where the tool stands before the first block, axis by axis in the unit of the format; what a format lacks of it
    /// stays where the format has it.
    pub(crate) fn stand(&mut self, at: &[Option<f64>]) -> Result<(), Fault> {
        self.at = self.rounded(at)?;
        Ok(())
    }

    /// Where an axis stands that the format has no word for.
    pub(crate) fn stand_by_hand(&mut self, axis: usize, value: f64) {
        let unit = crate::format::power_of_ten(self.control.axes[axis].decimals) as f64;
        self.at[axis] = (value * unit).round() as i64;
    }

    /// A value rounded to the least input increment of an axis, in the unit of the format.
    pub(crate) fn nearest(&self, axis: usize, value: f64) -> f64 {
        let unit = crate::format::power_of_ten(self.control.axes[axis].decimals) as f64;
        (value * unit).round() / unit
    }

    /// Text that becomes blocks as it stands. What it says of modes and positions is not followed.
    pub(crate) fn verbatim(&mut self, text: &str) {
        self.flush();
        self.text.push_str(text);
        self.text.push_str(&std::mem::take(&mut self.remarks));
        self.text.push('\n');
        self.last = None;
        self.forget();
    }

    /// Begins another program: what was in force is so no more, and the tool stands where it is.
    pub(crate) fn program(&mut self, number: &str) {
        self.finish();
        self.text.push('%');
        self.text.push_str(number);
        self.text.push('\n');
        self.modal = Modal::start(self.control);
        self.last = None;
    }

    /// The number of the program that begins the tape.
    pub(crate) fn first_program(&mut self, number: &str) {
        self.text.insert_str(1, number);
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

    /// The next motion has this preparatory function in its block, where it acts alone (G08, G09).
    pub(crate) fn once(&mut self, code: u8) -> Result<(), Fault> {
        self.code_word('G', i64::from(code))?;
        self.once = Some(code);
        Ok(())
    }

    /// Loads the registers of axes with numbers in the unit of the format (G92): no tool moves.
    pub(crate) fn preload(&mut self, at: &[Option<f64>]) -> Result<(), Fault> {
        let to = self.rounded(at)?;
        let mut words = vec![('G', self.code_word('G', 92)?)];
        for (axis, value) in at.iter().enumerate().take(to.len()) {
            if value.is_some() && self.control.axes[axis].sign.is_some() {
                let letter = self.control.axes[axis].letter;
                words.push((letter, self.dimension_word(letter, to[axis])?));
            }
        }
        self.block(words);
        self.at = to;
        Ok(())
    }

    /// A block with one function and another word: G41 and D.
    pub(crate) fn function_with(&mut self, address: char, code: u8, other: (char, i64)) -> Result<(), Fault> {
        let words =
            vec![(address, self.code_word(address, i64::from(code))?), (other.0, self.code_word(other.0, other.1)?)];
        self.block(words);
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
        let dwell = self.control.format.itemized.dwell.as_ref().ok_or(Fault::NoDwell)?;
        let word = self.plain_word(dwell.address, number)?;
        let preparatory = self.code_word('G', 4)?;
        self.block(vec![('G', preparatory), (dwell.address, word)]);
        Ok(())
    }
}

impl Modal {
    fn start(control: &Control) -> Modal {
        Modal { plane: Some(control.plane), feed_kind: Some(control.own_feed_kind()), ..Modal::default() }
    }
}
