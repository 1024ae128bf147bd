//! What a record says, in words.

use super::element::{Element, ElementKind};
use super::held::figure;
use super::record::Record;
use super::words::{Dialect, Key, Part, decode};
use super::{Cldata, type_name};

/// The units of lengths by their codes under 9000,9, from 1 on.
pub(super) const UNITS: [&str; 4] = ["millimetres", "centimetres", "inches", "feet"];

impl Cldata {
    /// What a record says, in a sentence or two; empty beyond the last one.
    pub fn says(&self, record: usize) -> String {
        let Some(found) = self.records().get(record) else { return String::new() };
        let mut said = self.sentence(found);
        if self.is_kept(record) {
            said.push_str(" Kept; the path does not show it.");
        }
        said
    }

    fn sentence(&self, record: &Record) -> String {
        let elements = self.elements(record);
        let whole = |place: usize| elements.get(place).and_then(Element::whole);
        let value = |place: usize| elements.get(place).and_then(Element::value);
        let literal = |place: usize| elements.get(place).and_then(|element| self.literal(element));
        let length = |place: usize| value(place).map_or_else(|| "?".to_owned(), figure);
        match (record.kind, whole(2)) {
            (1000, number) => {
                let number = number.map_or_else(|| "?".to_owned(), |number| number.to_string());
                let named = literal(3).filter(|name| !name.trim().is_empty());
                let named = named.map_or_else(String::new, |name| format!(", {}", name.trim()));
                let text = literal(4).map_or_else(String::new, |text| format!(": {}", text.trim()));
                format!("From statement {number} of the part program{named}{text}")
            }
            (2000 | 20000, _) => self.command_in_words(record),
            (3000, Some(which)) => self.surface_in_words(elements, which),
            (5000, Some(subtype)) => self.position_in_words(elements, subtype),
            (6000, Some(1)) if value(3) == Some(1.0) => "Motions are not put out from here on (DNTCUT).".to_owned(),
            (6000, Some(1)) => "Motions are put out from here on (CUT).".to_owned(),
            (6000, Some(3)) => format!("Tolerance of the path: {}.", length(3)),
            (6000, Some(4)) => format!("The path may lie inside of the part by {}.", length(3)),
            (6000, Some(5)) => format!("The path may lie outside of the part by {}.", length(3)),
            (6000, Some(6)) => match value(4) {
                Some(corner) if corner != 0.0 => {
                    format!("Cutter of diameter {}, its corner rounded by {}.", length(3), figure(corner))
                }
                _ => format!("Cutter of diameter {}.", length(3)),
            },
            (9000, Some(2)) if value(3) == Some(0.0) => "Positions have no tool axis from here on.".to_owned(),
            (9000, Some(2)) => "Positions have a tool axis from here on (MULTAX).".to_owned(),
            (9000, Some(9)) => {
                let unit = whole(3).and_then(|code| UNITS.get(usize::try_from(code).ok()?.checked_sub(1)?));
                unit.map_or_else(|| "A unit of lengths.".to_owned(), |unit| format!("Lengths are in {unit}."))
            }
            (14000, _) => "The file ends.".to_owned(),
            (kind, _) => match type_name(kind) {
                Some(name) => format!("{}{}.", name[..1].to_uppercase(), &name[1..]),
                None => "A record of a type that ISO 3592 does not have.".to_owned(),
            },
        }
    }

    /// "Feed: 60, per minute."
    fn command_in_words(&self, record: &Record) -> String {
        let elements = self.elements(record);
        let is_coded = record.kind == 2000;
        let dialect = self.dialect.unwrap_or(Dialect::Common);
        let coded = |part, element: &Element| {
            let code = u16::try_from(element.whole()?).ok()?;
            decode(part, code, dialect).map(|coded| coded.word)
        };
        let place = if is_coded { 2 } else { 3 };
        let word =
            elements.get(place).and_then(|element| if is_coded { coded(Part::Major, element) } else { element.key() });
        let word = match (word, elements.get(place)) {
            (Some(word), _) if word != Key(0) => word.word(),
            (_, Some(element)) if is_coded => element.whole().map_or_else(String::new, |code| format!("code {code}")),
            (_, Some(element)) => self.keyword(element),
            (_, None) => String::new(),
        };
        let rest: Vec<String> = elements
            .iter()
            .skip(place + 1)
            .map(|element| match element.kind {
                ElementKind::Literal => self.literal(element).unwrap_or_default().trim().to_owned(),
                ElementKind::Keyword => minor(&self.keyword(element)),
                ElementKind::Integer if is_coded => match coded(Part::Minor, element) {
                    Some(word) => minor(&word.word()),
                    None => format!("code {}", element.value().map_or_else(|| "?".to_owned(), figure)),
                },
                _ => element.value().map_or_else(|| "?".to_owned(), figure),
            })
            .collect();
        let meaning = MAJOR.iter().find(|row| row.0 == word).map_or(word.as_str(), |row| row.1);
        match (meaning, rest.is_empty()) {
            ("", _) => "A command without a word.".to_owned(),
            (meaning, true) => format!("{meaning}."),
            (meaning, false) => format!("{meaning}: {}.", rest.join(", ")),
        }
    }

    /// "Part surface: circle C1, centre X 0 Y 0 Z 5, radius 10, axis 0 0 1."
    fn surface_in_words(&self, elements: &[Element], which: i64) -> String {
        let reals: Vec<f64> = elements.iter().skip(8).filter_map(Element::value).collect();
        let kind = elements.get(4).and_then(Element::whole).unwrap_or(0);
        let shape = match kind {
            1 => "point",
            2 => "line",
            3 => "plane",
            4 => "circle",
            5 => "cylinder",
            8 => "cone",
            13 => "sphere",
            14 => "quadric",
            50 => "tabulated cylinder",
            53 => "ruled surface",
            _ => "surface",
        };
        let role = match which {
            1 => "Part surface",
            2 => "Drive surface",
            3 => "Check surface",
            4 => "Part surface of the motion",
            _ => "Surface",
        };
        let name = elements.get(6).and_then(|element| self.literal(element)).unwrap_or_default();
        let name = if name.trim().is_empty() { String::new() } else { format!(" {}", name.trim()) };
        let place = match (kind, &reals[..]) {
            (4 | 5, [x, y, z, i, j, k, radius, ..]) => {
                let axis = [i, j, k].map(|value| figure(*value)).join(" ");
                format!(", centre {}, radius {}, axis {axis}", place(&[*x, *y, *z]), figure(radius.abs()))
            }
            _ => String::new(),
        };
        let next = if which == 2 && matches!(kind, 4 | 5) { " The motion behind it goes along it." } else { "" };
        format!("{role}: {shape}{name}{place}.{next}")
    }

    /// "The tool goes to X 30 Y 40 Z 10."
    fn position_in_words(&self, elements: &[Element], subtype: i64) -> String {
        let values: Vec<f64> = elements.iter().skip(5).filter_map(Element::value).collect();
        // Whether points have a tool axis is not seen from the record alone: its place is told where there is one point.
        let one = matches!(values.len(), 3 | 6).then(|| place(&values[..3]));
        let first = values.get(..3).map_or_else(|| "?".to_owned(), place);
        let told = |one_point: &str, many: &str| match &one {
            Some(place) => format!("{one_point} {place}."),
            None => format!("{many} {first} and on ({} numbers).", values.len()),
        };
        match subtype {
            1 => "A hint at the direction, towards a point.".to_owned(),
            2 => "A hint at the direction, along a vector.".to_owned(),
            3 => told("The tool stands at", "The tool stands at"),
            4 => told("The tool goes on by", "The tool goes on by"),
            5 => told("The tool goes to", "The tool goes through"),
            6 => told("The motion goes on to", "The motion goes on through"),
            _ => "Tool position.".to_owned(),
        }
    }
}

/// "X 30 Y 40 Z 10"
fn place(values: &[f64]) -> String {
    let named = values.iter().zip(["X", "Y", "Z"]).map(|(value, axis)| format!("{axis} {}", figure(*value)));
    named.collect::<Vec<_>>().join(" ")
}

/// A minor word for people; itself where it says enough.
pub(super) fn minor(word: &str) -> String {
    MINOR.iter().find(|row| row.0 == word).map_or(word, |row| row.1).to_owned()
}

/// What the major words of ISO 4343 that one meets mean, as posts and their manuals use them; the standard's own
/// definitions are not public.
const MAJOR: &[(&str, &str)] = &[
    ("AUXFUN", "Miscellaneous function by its number"),
    ("BREAK", "The tape may be cut here"),
    ("CLAMP", "Clamp"),
    ("CLEARP", "Plane in which the tool is clear of the part"),
    ("CLRSRF", "Surface above which the tool is clear of the part"),
    ("COOLNT", "Coolant"),
    ("COPY", "Copies what stands between"),
    ("CUTCOM", "Cutter compensation"),
    ("CYCLE", "Cycle, carried out at every position from here on"),
    ("DELAY", "Dwell"),
    ("DISPLY", "Where remarks are shown"),
    ("END", "The machine’s run ends: spindle and coolant off"),
    ("FEDRAT", "Feed"),
    ("GOHOME", "The tool goes to its home position"),
    ("HEAD", "Head"),
    ("INDEX", "Marks what is copied"),
    ("INSERT", "Goes to the tape as it stands"),
    ("LEADER", "Blank tape"),
    ("LOADTL", "The tool is changed"),
    ("MACHIN", "Post-processor"),
    ("MODE", "Mode"),
    ("MULTAX", "Positions have a tool axis"),
    ("OPSKIP", "Blocks that the optional block skip switch leaves out"),
    ("OPSTOP", "The machine stops here if the operator wants it"),
    ("ORIGIN", "Origin of the machine, taken from every position"),
    ("PARTNO", "Part"),
    ("PPRINT", "Remark"),
    ("PREFUN", "Preparatory function by its number"),
    ("RAPID", "The next motion is at rapid traverse"),
    ("RESET", "Reset"),
    ("RETRCT", "The tool draws back"),
    ("REWIND", "The tape is wound back"),
    ("ROTABL", "Rotary table"),
    ("ROTHED", "Rotary head"),
    ("SELCTL", "The next tool is made ready"),
    ("SEQNO", "Numbers of the blocks"),
    ("SPINDL", "Spindle"),
    ("STOP", "The machine stops here"),
    ("THREAD", "A thread is cut"),
    ("TMARK", "Mark on the tape"),
    ("TOOLNO", "Tool"),
    ("TRACUT", "Positions are to be transformed"),
    ("TRANS", "Shift of every position"),
    ("TURRET", "Turret"),
    ("UNITS", "Unit of lengths"),
    ("UNLOAD", "The tool is put away"),
];

/// Minor words that are not what they say.
const MINOR: &[(&str, &str)] = &[
    ("CCLW", "counter-clockwise"),
    ("CLEAR", "clearance"),
    ("CLW", "clockwise"),
    ("CM", "centimetres"),
    ("DEEP", "deep drilling"),
    ("DEPTH", "depth"),
    ("DRILL", "drilling"),
    ("DWELL", "dwell"),
    ("FEET", "feet"),
    ("FLOOD", "flood"),
    ("FPT", "per tooth"),
    ("INCHES", "inches"),
    ("INVERS", "as the reciprocal of time"),
    ("IPM", "inches per minute"),
    ("IPR", "inches per revolution"),
    ("LEFT", "left"),
    ("LENGTH", "length"),
    ("MIST", "mist"),
    ("MM", "millimetres"),
    ("MMPM", "millimetres per minute"),
    ("MMPR", "millimetres per revolution"),
    ("OFF", "off"),
    ("ON", "on"),
    ("PERMIN", "per minute"),
    ("PERREV", "per revolution"),
    ("RADIUS", "radius"),
    ("RAPTO", "at rapid to"),
    ("REV", "revolutions"),
    ("RIGHT", "right"),
    ("RPM", "revolutions per minute"),
    ("SFM", "feet per minute at the surface"),
    ("SMM", "metres per minute at the surface"),
    ("STEP", "step"),
    ("TAP", "tapping"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cldata::Options;

    #[test]
    fn the_words_are_in_order() {
        assert!(MAJOR.is_sorted_by_key(|row| row.0) && MINOR.is_sorted_by_key(|row| row.0));
    }

    #[test]
    fn records_in_words() {
        for (record, words) in [
            ("1000,13,'110','GOTO/P1'", "From statement 13 of the part program, 110: GOTO/P1"),
            ("20000,0,FEDRAT,60.,PERMIN", "Feed: 60, per minute."),
            ("2000,1031,2000.,60", "Spindle: 2000, clockwise."),
            ("20000,0,PPRINT,'It''s one'", "Remark: It's one."),
            ("20000,0,RAPID", "The next motion is at rapid traverse."),
            ("5000,3,'',0,.,-2.5,3.", "The tool stands at X 0 Y -2.5 Z 3."),
            ("5000,5,'',0,1.,2.,3.,4.,5.,6.,7.,8.,9.", "The tool goes through X 1 Y 2 Z 3 and on (9 numbers)."),
            (
                "3000,2,0,4,9,'C1',0,.,.,5.,.,.,1.,10.",
                "Drive surface: circle C1, centre X 0 Y 0 Z 5, radius 10, axis 0 0 1. The motion behind it goes along it.",
            ),
            ("6000,6,10.,2.", "Cutter of diameter 10, its corner rounded by 2."),
            ("9000,9,3", "Lengths are in inches."),
            ("15000,1,2.", "Unsegmented tool path. Kept; the path does not show it."),
            ("2600,1", "A record of a type that ISO 3592 does not have. Kept; the path does not show it."),
            ("14000", "The file ends."),
        ] {
            let cldata = Cldata::new(&format!("1,{record};:"), &Options::default());
            assert_eq!(cldata.says(0), words, "{record}");
        }
    }
}
