//! Why something cannot be said in a format, and in which words.

use crate::speed::NoCode;

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
    /// The format has no word for the time of a dwell.
    NoDwell,
    /// The format's control has no arcs and parabolas.
    NoContouring,
    /// The third axis moves in an arc, and the format has no helix.
    Helix,
    /// The format declares no code for a cubic.
    NoCubic,
}

impl Fault {
    /// It in words, a sentence without its full stop.
    pub(crate) fn told(&self) -> String {
        match self {
            Fault::NoWord(address) => format!("The format has no word {address}"),
            Fault::TooLong { address, value, before } => {
                format!("{address}{value} does not fit: {address} has {before} digits before its decimal sign")
            }
            Fault::Negative { address, value } => format!("{address}{value} does not fit: {address} has no sign"),
            Fault::Speed { address, value, why } => {
                let why = match why {
                    NoCode::Below(least) => format!("the least that its coding can say is {least}"),
                    NoCode::Above(most) => format!("the greatest that its coding can say is {most}"),
                    NoCode::NoTable => "the format gives its symbolic codes no values".to_owned(),
                    NoCode::Digits => "its coding has no codes of so many digits".to_owned(),
                    NoCode::NotASpeed => "it is no speed".to_owned(),
                };
                format!("{value} has no code in {address}: {why}")
            }
            Fault::NoFeed => "No feed is known for this cut".to_owned(),
            Fault::NoDwell => "The format names no word for the time of a dwell".to_owned(),
            Fault::NoContouring => "ISO 1058 has no arcs and no parabolas".to_owned(),
            Fault::Helix => "The third axis moves in an arc, which the control does not do".to_owned(),
            Fault::NoCubic => "The format declares no code for a curve of higher order".to_owned(),
        }
    }
}
