//! What a file holds at a record, in words.

use super::Cldata;
use super::execution::Per;
use super::words::Key;
use crate::format::Unit;

/// What a file has said when a record has been carried out.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Where the tool is, in the unit of [`Cldata::unit`]; `None` while nothing has said so.
    pub position: Option<[f64; 3]>,
    /// What else holds: always the same names in the same order.
    pub registers: Vec<Register>,
}

/// One thing that a file has said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Register {
    /// What it is about.
    pub name: &'static str,
    /// What holds.
    pub says: String,
    /// The file has said so; otherwise it is taken for granted, or nothing is known.
    pub stated: bool,
}

impl Cldata {
    /// What holds when a record has been carried out; `None` beyond the last one.
    pub fn held(&self, record: usize) -> Option<Held> {
        self.records().get(record)?;
        let file = self.execution.behind(record, &self.tables, self.dialect)?;
        let unit = if self.unit() == Unit::Inch { "in" } else { "mm" };
        let length = |value: f64| format!("{} {unit}", figure(value));
        let mut registers = Vec::new();
        let mut tell = |name, says: String, stated| registers.push(Register { name, says, stated });

        let next = match (file.rapid, file.circle) {
            (Some(_), Some(_)) => "along a circle, at rapid",
            (Some(_), None) => "straight, at rapid",
            (None, Some(_)) => "along a circle",
            (None, None) if file.cycle => "a cycle at its end",
            (None, None) => "straight, at the feed",
        };
        tell("Next", next.to_owned(), file.rapid.is_some() || file.circle.is_some() || file.cycle);
        let per = match file.per {
            Per::Minute => format!("{unit}/min"),
            Per::Revolution => format!("{unit}/rev"),
            Per::Other => "not by length and time".to_owned(),
        };
        let feed = file.feed.map_or_else(|| "not stated".to_owned(), |feed| format!("{} {per}", figure(feed)));
        tell("Feed", feed, file.feed.is_some());
        let way = match file.way.map(Key::word).as_deref() {
            Some("CLW") => " clockwise",
            Some("CCLW") => " counter-clockwise",
            _ => "",
        };
        let spindle = match (file.turning, file.speed) {
            _ if !file.spindle_is_told => "not stated".to_owned(),
            (false, _) => "off".to_owned(),
            (true, None) => format!("on{way}"),
            (true, Some(speed)) => format!("{} rev/min{way}", figure((speed * 10.0).round() / 10.0)),
        };
        tell("Spindle", spindle, file.spindle_is_told);
        let coolant = file.coolant.map(|word| super::says::minor(&word.word()));
        tell("Coolant", coolant.clone().unwrap_or_else(|| "not stated".to_owned()), coolant.is_some());
        let tool = file.tool.map(|tool| format!("number {}", figure(tool)));
        tell("Tool", tool.clone().unwrap_or_else(|| "not stated".to_owned()), tool.is_some());
        let cutter = file.cutter.map(|cutter| format!("diameter {}", length(cutter)));
        tell("Cutter", cutter.clone().unwrap_or_else(|| "not stated".to_owned()), cutter.is_some());
        let axis = match file.tool_axis {
            Some(axis) => axis.map(figure).join("  "),
            None => "along Z".to_owned(),
        };
        tell("Tool axis", axis, file.tool_axis.is_some());
        let unit = file.unit.and_then(|code| super::says::UNITS.get(usize::try_from(code).ok()?.checked_sub(1)?));
        tell("Lengths", unit.unwrap_or(&super::says::UNITS[0]).to_string(), unit.is_some());
        tell("Motions", if file.cut { "put out" } else { "not put out" }.to_owned(), !file.cut);
        Some(Held { position: file.position, registers })
    }
}

/// A number with at most four places, which is as fine as such files are worth.
pub(super) fn figure(value: f64) -> String {
    let rounded = (value * 1e4).round() / 1e4;
    // Zero has no sign for people.
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}
