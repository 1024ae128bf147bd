//! The symbolic code (ISO 1058 A.3): one of the speeds that the machine has, by its number in the format.

use super::{Code, NoCode, direct::greatest, nearest};
use std::collections::BTreeMap;

/// The value of a code: the table may write "7" or "07".
pub fn decode(table: Option<&BTreeMap<String, f64>>, code: i64) -> Option<f64> {
    table?.iter().find(|(name, _)| name.trim().parse() == Ok(code)).map(|(_, value)| *value)
}

/// The code of the speed nearest in ratio; of speed zero, that of a stop, if there is one.
pub fn encode(table: Option<&BTreeMap<String, f64>>, speed: f64, digits: u16) -> Result<Code, NoCode> {
    let most = greatest(digits).ok_or(NoCode::Digits)?;
    let codes = || {
        let entries = table.into_iter().flatten();
        let codes = entries.filter_map(|(name, value)| Some((name.trim().parse::<i64>().ok()?, *value)));
        codes.filter(|(code, _)| (0..=most).contains(code))
    };
    let found = if speed == 0.0 {
        codes().find(|value| value.1 == 0.0)
    } else {
        nearest(speed, codes().filter(|value| value.1 > 0.0))
    };
    match found {
        Some((number, _)) => Ok(Code { number, digits }),
        None => {
            let least = codes().map(|value| value.1).filter(|value| *value > 0.0).reduce(f64::min);
            Err(least.map_or(NoCode::NoTable, NoCode::Below))
        }
    }
}
