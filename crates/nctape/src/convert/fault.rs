//! What a format cannot say, in words.

use crate::speed::NoCode;
use crate::write::Fault;

/// What a format cannot say, in words.
pub(super) fn told(fault: &Fault) -> String {
    let what = match fault {
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
        Fault::NoContouring => "ISO 1058 has no arcs and no parabolas".to_owned(),
        Fault::Helix => "The third axis moves in an arc, which the control does not do".to_owned(),
        Fault::NoCubic => "The format declares no code for a curve of higher order".to_owned(),
    };
    format!("{what}. It is not converted, and the tape stops there.")
}
