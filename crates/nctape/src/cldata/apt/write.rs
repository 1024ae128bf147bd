//! Records of the reference language, numbered from 1, one on a line.

use super::Argument;
use std::fmt::Write as _;

#[derive(Default)]
pub(super) struct Writer {
    pub text: String,
    records: u32,
    /// Points have six values.
    multax: bool,
    /// The tool axis of the last point that gave one, as written.
    axis: Option<[String; 3]>,
}

impl Writer {
    /// Where the records that follow come from (6.2): the line of the CL text, and the statement where it is kept.
    pub fn origin(&mut self, line: usize, statement: Option<&str>) {
        let kept = statement.map(|statement| format!(",{}", literal(statement))).unwrap_or_default();
        self.record(&format!("1000,{line},''{kept}"));
    }

    /// A literal type command (6.14).
    pub fn command(&mut self, word: &str, arguments: &[Argument<'_>]) {
        let mut record = format!("20000,0,{word}");
        for argument in arguments {
            record.push(',');
            match argument {
                Argument::Number(number) => record.push_str(&real(number)),
                Argument::Word(word) => record.push_str(word),
                Argument::Text(text) => record.push_str(&literal(text)),
            }
        }
        self.record(&record);
    }

    /// A tool position (6.6). Where points have a tool axis and this one gives none, it keeps the last one; before the
    /// first it is Z.
    pub fn tool_position(&mut self, subtype: u8, numbers: &[&str]) {
        let mut reals: Vec<String> = numbers.iter().map(|number| real(number)).collect();
        if let [_, _, _, i, j, k] = &reals[..] {
            self.axis = Some([i.clone(), j.clone(), k.clone()]);
        } else if self.multax {
            reals.extend(self.axis.clone().unwrap_or_else(|| [".", ".", "1."].map(str::to_owned)));
        }
        self.record(&format!("5000,{subtype},'',0,{}", reals.join(",")));
    }

    /// The circle that the motion behind it follows (6.4): the drive surface, the tool on it, and nine words, which are
    /// symbol, subscript, centre, axis and radius.
    pub fn circle(&mut self, numbers: &[&str]) {
        let reals: Vec<String> = numbers.iter().map(|number| real(number)).collect();
        self.record(&format!("3000,2,0,4,9,'',0,{}", reals.join(",")));
    }

    /// Tolerances and the cutter (6.7).
    pub fn information(&mut self, subtype: u8, numbers: &[&str]) {
        let reals: Vec<String> = numbers.iter().map(|number| real(number)).collect();
        self.record(&format!("6000,{subtype},{}", reals.join(",")));
    }

    /// Whether points are machined: 0 CUT, 1 DNTCUT.
    pub fn cut_flag(&mut self, cuts: bool) {
        self.record(&format!("6000,1,{}", u8::from(!cuts)));
    }

    /// The length unit (6.10).
    pub fn unit(&mut self, code: u8) {
        self.record(&format!("9000,9,{code}"));
    }

    /// Whether points have a tool axis (6.10); said where it changes.
    pub fn multax(&mut self, line: usize, on: bool) {
        if self.multax != on {
            self.origin(line, None);
            self.record(&format!("9000,2,{}", u8::from(on)));
        }
        self.multax = on;
    }

    /// The end of the part program (6.11).
    pub fn end(&mut self) {
        self.record("14000");
    }

    /// The whole text, the file ended (5.16).
    pub fn finish(mut self) -> String {
        if self.records > 0 {
            self.text.push_str(":\n");
        }
        self.text
    }

    fn record(&mut self, elements: &str) {
        self.records += 1;
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{},{elements};", self.records);
    }
}

/// A literal, its apostrophes doubled (5.7).
fn literal(text: &str) -> String {
    format!("'{}'", text.replace('\'', "''"))
}

/// A real number (5.10): with a point, without zeros that say nothing.
fn real(number: &str) -> String {
    let (sign, rest) = match number.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", number.strip_prefix('+').unwrap_or(number)),
    };
    let (mantissa, exponent) = match rest.split_once(['E', 'e']) {
        Some((mantissa, exponent)) => (mantissa, format!("E{exponent}")),
        None => (rest, String::new()),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let (whole, fraction) = (whole.trim_start_matches('0'), fraction.trim_end_matches('0'));
    let zero = whole.is_empty() && fraction.is_empty();
    format!("{}{whole}.{fraction}{}", if zero { "" } else { sign }, if zero { "" } else { &exponent })
}
