//! From a tape to the language of another control, and back.
//!
//! A conversion follows the blocks as they are executed and takes the path from the spans, so that whatever a format
//! leaves open (dimensions, readings of I, J and K, codings of feeds) is settled before it. What it cannot express it
//! leaves out, marks in the text and says in a diagnostic of the family CONV: nothing is dropped silently.

mod between;
mod comments;
mod fault;
mod from_decimal;
mod gcode;
mod linuxcnc;
mod noted;
mod output;

use crate::diagnostic::Diagnostic;
use crate::format::{Format, choices};
use crate::tape::Tape;
use std::ops::Range;

choices! {
    /// A dialect of decimal G-code.
    Dialect {
        /// LinuxCNC 2.5 and later: RS274/NGC.
        LinuxCnc = "linuxcnc", "LinuxCNC";
    }
}

/// What a conversion gave.
#[derive(Clone, Debug, Default)]
pub struct Converted {
    /// The text.
    pub text: String,
    /// What could not be carried over, and what was written otherwise than a reader may expect; by position in the
    /// source. Rules of the family CONV.
    pub diagnostics: Vec<Diagnostic>,
    /// What became of each executed block: its bytes in the source and those of the text, in the order of the text. A
    /// block that gave nothing has an empty range; one that shares a motion with another is linked to its lines too.
    pub map: Vec<(Range<usize>, Range<usize>)>,
}

/// Decimal G-code that does what a tape does, with the optional block skip switch off.
///
/// Any text gives a conversion. Lengths are in the unit of the format, absolute, with as many decimal places as the
/// least input increment has; the feed of each span is that of the tape, whatever its coding.
///
/// ```
/// use nctape::convert::{Dialect, to_decimal};
/// use nctape::{Format, Standard};
/// let format = Format::new(Standard::Iso2539, "N3G2X+42Y+42F4M2*").classified("CAM 222");
/// let program = to_decimal("%\nN001 G01 X+001000 Y-000500 F0300 M30\n", &format, Dialect::LinuxCnc);
/// assert!(program.text.contains("N001 G1 X10.00 Y-5.00 F300\nM30\n"));
/// assert!(program.diagnostics.is_empty());
/// ```
pub fn to_decimal(source: &str, format: &Format, dialect: Dialect) -> Converted {
    match dialect {
        Dialect::LinuxCnc => linuxcnc::write(&Tape::new(source, format)),
    }
}

/// A tape of a format that does what decimal G-code does: text of LinuxCNC, and what other controls of today read the
/// same way.
///
/// Any text gives a tape. Lengths are converted to the unit of the format and rounded to its least input increment; what
/// the format cannot say is reported, and the tape stops there (M00). The optional block skip character stays where it
/// is.
///
/// ```
/// use nctape::convert::from_decimal;
/// use nctape::{Format, Standard};
/// let format = Format::new(Standard::Iso2539, "N3G2X+42Y+42F4M2*").classified("CAM 222");
/// let tape = from_decimal("G21\nG1 X10.5 Y-3 F300\nM30\n", &format);
/// assert_eq!(tape.text, "%\nN001 G01 X+001050 Y-000300 F0300\nN002 M30\n");
/// assert!(tape.diagnostics.is_empty());
/// ```
pub fn from_decimal(source: &str, to: &Format) -> Converted {
    from_decimal::write(source, to)
}

/// A tape of one format as a tape of another, with the optional block skip switch off.
///
/// Any text gives a tape. It is executed as `from` says, and what it does is written as `to` says it: the same path in
/// the unit, dimensions and readings of the other format, the same functions, feeds and speeds in its codings. What that
/// format cannot say is reported, and the tape stops there (M00).
///
/// ```
/// use nctape::convert::convert;
/// use nctape::{Format, Standard};
/// let from = Format::new(Standard::Iso2539, "N3G2X+42Y+42F4M2*").classified("CAM 222");
/// let to = Format::new(Standard::Iso2539, "N4.G2.XD33.YD33.F4.M2*").classified("CSM 222");
/// let tape = convert("%\nN001 G01 X+001050 Y-000300 F0300\nN002 M30\n", &from, &to);
/// assert_eq!(tape.text, "%\nN0001\tG01\tX+010500\tY-003000\tF0300\nN0002\t\t\t\t\tM30\n");
/// assert!(tape.diagnostics.is_empty());
/// ```
pub fn convert(source: &str, from: &Format, to: &Format) -> Converted {
    between::write(&Tape::new(source, from), to)
}
