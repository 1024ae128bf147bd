//! Itemized data: what the standards leave to the builder of the control.
//!
//! Annex F of ISO 2539, which guides it, is not in the printed copy at hand; the fields are what the clauses
//! themselves hand over (3.3.3, 3.3.4, 4.1.4, 4.2, 5, annexes A and B). A field that is not stated has a default: the
//! printed standard's reading.

use super::choice::choices;
use super::value::{Positive, Setting, Value, choice_settings, map, number};
use crate::code::{Code, EndOfBlock};
use std::collections::BTreeMap;

choices! {
    /// Absolute or incremental dimensions.
    Dimensions {
        /// Measured from the origin.
        Absolute = "absolute", "absolute, from the origin";
        /// Measured from where the tool stands.
        Incremental = "incremental", "incremental, from where the tool stands";
    }
}

choices! {
    /// A principal plane.
    Plane {
        /// G17.
        Xy = "xy", "XY (G17)";
        /// G18: the first axis is Z, the second X.
        Zx = "zx", "ZX (G18)";
        /// G19.
        Yz = "yz", "YZ (G19)";
    }
}

impl Plane {
    /// Its first, second and third axis as indices into X, Y, Z; the third is the one it is seen from.
    pub fn axes(self) -> [usize; 3] {
        match self {
            Plane::Xy => [0, 1, 2],
            Plane::Zx => [2, 0, 1],
            Plane::Yz => [1, 2, 0],
        }
    }
}

choices! {
    /// What I, J and K say of an arc.
    ArcParameters {
        /// The centre.
        Centre = "centre", "the centre";
        /// I the included angle, J the radius.
        AngleRadius = "angle-radius", "I the included angle, J the radius";
    }
}

choices! {
    /// How I, J and K give a point: the centre of an arc, the tangent intersection point or focus of a parabola.
    ArcCentre {
        /// ISO 2539 figures 2 and 3: absolute coordinates under absolute dimensions, centre minus start under incremental.
        AsDimensions = "as-dimensions", "like the dimensions (figure 2)";
        /// Centre minus start, whatever the dimensions.
        FromStart = "from-start", "centre minus start";
        /// Start minus centre: the circular tape of annex E.
        ToStart = "to-start", "start minus centre (annex E)";
        /// Absolute coordinates, whatever the dimensions.
        Absolute = "absolute", "absolute coordinates";
        /// Unsigned, within one quadrant.
        Quadrant = "quadrant", "without sign, within one quadrant";
    }
}

choices! {
    /// What I, J and K say of a parabola.
    ParabolaParameters {
        /// The intersection point of the tangents at the ends.
        Tangent = "tangent", "the tangent intersection point";
        /// dY/dX at start and end.
        Slope = "slope", "I and J the slopes at start and end";
        /// The focus.
        Focus = "focus", "the focus";
    }
}

choices! {
    /// A curve of higher order, through points in successive blocks.
    CurveKind {
        /// A cubic.
        Cubic = "cubic", "cubic";
    }
}

choices! {
    /// How an F word says a speed: annex A.
    FeedCoding {
        /// The reciprocal of the time for the block, in 1/min.
        TimeReciprocal = "time-reciprocal", "reciprocal of time (A.1)";
        /// Arithmetic progression: magnitude and digits.
        Arithmetic = "arithmetic", "arithmetic progression (A.2)";
        /// Geometric progression: two digits of a table.
        Geometric = "geometric", "geometric progression (A.3)";
        /// One digit with a value in the itemized data.
        Symbolic = "symbolic", "symbolic";
        /// The speed itself.
        Direct = "direct", "direct";
    }
}

choices! {
    /// How an S word says a speed: annex A.
    SpindleCoding {
        /// Arithmetic progression: magnitude and digits.
        Arithmetic = "arithmetic", "arithmetic progression (A.2)";
        /// Geometric progression: two digits of a table.
        Geometric = "geometric", "geometric progression (A.3)";
        /// One digit with a value in the itemized data.
        Symbolic = "symbolic", "symbolic";
        /// The speed itself.
        Direct = "direct", "direct";
    }
}

choices! {
    /// How the vector of cutter compensation lies to the path at the start of its span (clause 5 leaves it open).
    CompensationVector {
        /// At right angles to it: the direction in which the cutter is offset.
        Normal = "normal", "normal to the path";
        /// Along it; the side is that of G41 or G42.
        Tangent = "tangent", "tangent to the path";
    }
}

choices! {
    /// What a feed is counted against.
    FeedUnit {
        /// Millimetres or inches per minute.
        PerMinute = "per-minute", "per minute";
        /// Millimetres or inches per revolution of the spindle.
        PerRevolution = "per-revolution", "per revolution";
    }
}

choices! {
    /// Time-reciprocal feed on arcs.
    ArcFeed {
        /// Radians per minute: ISO 2539 A.1.2.
        Radians = "radians", "radians per minute (A.1.2)";
        /// The reciprocal of time, as on lines: the circular tape of annex E.
        Time = "time", "reciprocal of time (annex E)";
    }
}

/// F is this number divided by minutes: 1, or 10 as RS-274's feed rate number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimeScale(pub u8);

/// Where the tool stands before the first block, in the unit of the format.
#[derive(Clone, Debug, PartialEq)]
pub enum SetPoint {
    /// In the order of the format's axes.
    InOrder(Vec<f64>),
    /// By axis letter.
    Named(BTreeMap<String, f64>),
}

/// The word that carries the time of a dwell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dwell {
    /// Its address.
    pub address: char,
    /// What it counts.
    pub unit: DwellUnit,
}

choices! {
    /// What a dwell is counted in.
    DwellUnit {
        /// Seconds.
        Seconds = "seconds", "seconds";
        /// Revolutions of the spindle.
        Revolutions = "revolutions", "revolutions of the spindle";
    }
}

/// Functions and letters to which the builder gave a meaning.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Declared {
    /// Preparatory functions by their code, "G05".
    pub g: BTreeMap<String, String>,
    /// Miscellaneous functions by their code, "M52".
    pub m: BTreeMap<String, String>,
    /// Address letters.
    pub letters: BTreeMap<String, String>,
}

choices! {
    /// The character code of a tape, as a format names it.
    TapeCode {
        /// ISO 840.
        Iso = "iso", "ISO 840 (RS-358), even parity";
        /// EIA RS-244.
        Eia = "eia", "EIA RS-244, odd parity";
    }
}

impl From<TapeCode> for Code {
    fn from(code: TapeCode) -> Code {
        match code {
            TapeCode::Iso => Code::Iso,
            TapeCode::Eia => Code::Eia,
        }
    }
}

choices! {
    /// The row that ends a block in ISO code.
    TapeEnd {
        /// LF.
        Lf = "lf", "LF (ISO 2539 B.2)";
        /// CR.
        Cr = "cr", "CR (the text of Y-1702)";
    }
}

impl From<TapeEnd> for EndOfBlock {
    fn from(end: TapeEnd) -> EndOfBlock {
        match end {
            TapeEnd::Lf => EndOfBlock::Lf,
            TapeEnd::Cr => EndOfBlock::Cr,
        }
    }
}

choice_settings!(
    TapeCode,
    TapeEnd,
    Dimensions,
    Plane,
    ArcParameters,
    ArcCentre,
    ParabolaParameters,
    FeedCoding,
    SpindleCoding,
    FeedUnit,
    ArcFeed,
    CompensationVector
);

impl Setting for TimeScale {
    const KIND: &'static str = "number";
    fn read(value: &Value) -> Option<Self> {
        match number(value) {
            Some(1.0) => Some(TimeScale(1)),
            Some(10.0) => Some(TimeScale(10)),
            _ => None,
        }
    }
    fn write(&self) -> Value {
        Value::Number(f64::from(self.0))
    }
    fn allowed() -> String {
        "1 or 10".to_owned()
    }
}

impl Setting for SetPoint {
    const KIND: &'static str = "position";
    fn read(value: &Value) -> Option<Self> {
        match value {
            Value::List(numbers) => numbers.iter().map(number).collect::<Option<_>>().map(SetPoint::InOrder),
            _ => map(value, number).map(SetPoint::Named),
        }
    }
    fn write(&self) -> Value {
        match self {
            SetPoint::InOrder(numbers) => Value::List(numbers.iter().map(|n| Value::Number(*n)).collect()),
            SetPoint::Named(numbers) => numbers.write(),
        }
    }
    fn allowed() -> String {
        "numbers in the order of the axes, [10, 10, 20], or by axis, {\"Z\": 20}".to_owned()
    }
}

impl Setting for Dwell {
    const KIND: &'static str = "json";
    fn read(value: &Value) -> Option<Self> {
        let (Some(Value::Text(address)), Some(Value::Text(unit))) = (value.get("address"), value.get("unit")) else {
            return None;
        };
        let mut letters = address.chars();
        let address = letters.next().filter(char::is_ascii_uppercase)?;
        if letters.next().is_some() {
            return None;
        }
        Some(Dwell { address, unit: DwellUnit::from_word(unit)? })
    }
    fn write(&self) -> Value {
        Value::Map(vec![
            ("address".to_owned(), Value::Text(self.address.to_string())),
            ("unit".to_owned(), Value::Text(self.unit.word().to_owned())),
        ])
    }
    fn allowed() -> String {
        "an address and a unit, {\"address\": \"X\", \"unit\": \"seconds\"} or \"revolutions\"".to_owned()
    }
}

impl Setting for Declared {
    const KIND: &'static str = "json";
    fn read(value: &Value) -> Option<Self> {
        let Value::Map(fields) = value else { return None };
        let mut declared = Declared::default();
        for (name, value) in fields {
            let texts = BTreeMap::<String, String>::read(value)?;
            match name.as_str() {
                "G" => declared.g = texts,
                "M" => declared.m = texts,
                "letters" => declared.letters = texts,
                _ => return None,
            }
        }
        Some(declared)
    }
    fn write(&self) -> Value {
        let parts = [("G", &self.g), ("M", &self.m), ("letters", &self.letters)];
        let stated = parts.iter().filter(|(_, texts)| !texts.is_empty());
        Value::Map(stated.map(|(name, texts)| ((*name).to_owned(), texts.write())).collect())
    }
    fn allowed() -> String {
        "texts under \"G\", \"M\" and \"letters\", such as {\"G\": {\"G05\": \"hold\"}}".to_owned()
    }
}

impl Setting for BTreeMap<String, CurveKind> {
    const KIND: &'static str = "json";
    fn read(value: &Value) -> Option<Self> {
        map(value, |value| if let Value::Text(word) = value { CurveKind::from_word(word) } else { None })
    }
    fn write(&self) -> Value {
        Value::Map(self.iter().map(|(code, kind)| (code.clone(), Value::Text(kind.word().to_owned()))).collect())
    }
    fn allowed() -> String {
        "a kind for each G code, such as {\"G07\": \"cubic\"}".to_owned()
    }
}

/// What is known of one field: its name in a format and the words for people.
#[derive(Clone, Debug)]
pub struct ItemizedField {
    /// Its name in a format, "arcCentre".
    pub name: &'static str,
    /// The fields that belong together.
    pub group: &'static str,
    /// What it is called.
    pub label: &'static str,
    /// What it decides.
    pub help: &'static str,
    /// What holds while it is not stated.
    pub default: &'static str,
    /// How a page may let a person edit it.
    pub kind: &'static str,
    /// The words and titles, where it is one of a few.
    pub choices: Vec<(&'static str, &'static str)>,
}

/// Declares the fields once: the struct, reading, writing and the words for people.
macro_rules! itemized {
    ($($(#[$doc:meta])* $field:ident: $kind:ty, $name:literal, $group:literal, $label:literal, $default:literal, $help:literal;)+) => {
        /// Itemized data. A field that is `None` is not stated and has its default.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct Itemized { $($(#[$doc])* pub $field: Option<$kind>,)+ }

        impl Itemized {
            /// Reads the field `name`; says what is allowed where the value does not fit, `Ok(false)` where
            /// there is no such field.
            pub(crate) fn read_field(&mut self, name: &str, value: &Value) -> Result<bool, String> {
                match name {
                    $($name => match <$kind>::read(value) {
                        Some(setting) => self.$field = Some(setting),
                        None => return Err(<$kind>::allowed()),
                    },)+
                    _ => return Ok(false),
                }
                Ok(true)
            }

            /// The stated fields.
            pub(crate) fn write(&self) -> Vec<(String, Value)> {
                let mut fields = Vec::new();
                $(if let Some(setting) = &self.$field { fields.push(($name.to_owned(), setting.write())); })+
                fields
            }

            /// All fields, in the order in which they are shown.
            pub fn fields() -> Vec<ItemizedField> {
                vec![$(ItemizedField {
                    name: $name,
                    group: $group,
                    label: $label,
                    help: $help,
                    default: $default,
                    kind: <$kind>::KIND,
                    choices: <$kind>::choices(),
                },)+]
            }
        }
    };
}

itemized! {
    /// The character code of the tape.
    code: TapeCode, "code", "Tape", "Character code", "ISO 840", "Which holes stand for a character.";
    /// The end-of-block row in ISO code.
    end_of_block: TapeEnd, "endOfBlock", "Tape", "End of block in ISO code", "LF", "Which row ends a block.";
    /// Digits of a program number after `%`.
    program_number_digits: u8, "programNumberDigits", "Tape", "Digits of a program number", "none", "A number right behind the program start character marks one of several programs on a tape (B.2 note 3).";
    /// Rows per second.
    reader_speed: Positive, "readerSpeed", "Tape", "Reader speed in rows per second", "300", "How fast the reader draws the tape: the time that reading it takes follows from it, and the pace of the replay over blocks that move nothing.";
    /// One block is read ahead.
    buffered: bool, "buffered", "Tape", "Block buffer", "yes", "Whether the next block is read while this one is executed. Without it the tool stands for the reading of every block.";

    /// Dimensions at the start, where the detail leaves it open.
    dimensions: Dimensions, "dimensions", "Dimensions", "Dimensions at the start", "absolute", "Where the detail has L, and always under RS-274: how dimension words are read until G90 or G91.";
    /// Where the tool stands before the first block.
    set_point: SetPoint, "setPoint", "Dimensions", "Set point", "0 on every axis", "Where the tool stands before the first block.";
    /// Travel of the axes.
    travel: BTreeMap<String, (f64, f64)>, "travel", "Dimensions", "Travel", "not stated", "Least and greatest coordinate of each axis.";

    /// The plane at the start.
    plane: Plane, "plane", "Interpolation", "Plane at the start", "XY", "The plane of arcs until G17, G18 or G19.";
    /// What I, J, K say of an arc.
    arc_parameters: ArcParameters, "arcParameters", "Interpolation", "Arc parameters", "the centre", "What I, J and K say of an arc (4.1.4).";
    /// How I, J, K give a point.
    arc_centre: ArcCentre, "arcCentre", "Interpolation", "Reading of I, J, K", "like the dimensions (figure 2)", "How the centre of an arc, or the tangent intersection point or focus of a parabola, is given. The standard contradicts itself: its figure 2 has centre minus start, its annex E start minus centre.";
    /// What I, J, K say of a parabola.
    parabola_parameters: ParabolaParameters, "parabolaParameters", "Interpolation", "Parabola parameters", "the tangent intersection point", "What I, J and K say of a parabola. Slopes are those of the second axis of the plane over the first.";
    /// A third axis may move in an arc block.
    helix: bool, "helix", "Interpolation", "Helix", "where the third digit of the classification is 3 or more", "Whether a third axis may move in an arc block.";
    /// End equal to start is a full circle.
    full_circle: bool, "fullCircle", "Interpolation", "Full circle", "yes, with a note", "Whether an arc that ends where it starts is a full circle.";
    /// Curves of higher order.
    curves: BTreeMap<String, CurveKind>, "curves", "Interpolation", "Higher-order curves", "none", "G codes for curves of higher order (4.2.4): a cubic runs through the points of three successive blocks.";

    /// Coding of F.
    feed: FeedCoding, "feed", "Speeds", "Feed coding", "direct; ISO 1058: by the digits of F", "How an F word says the feed (annex A).";
    /// What the feed is counted against.
    feed_unit: FeedUnit, "feedUnit", "Speeds", "Feed unit", "per minute", "What the feed is counted against.";
    /// Time-reciprocal feed on arcs.
    arc_feed: ArcFeed, "arcFeed", "Speeds", "Time-reciprocal feed on arcs", "radians per minute (A.1.2)", "The standard contradicts itself: A.1.2 has radians per minute, annex E the reciprocal of time.";
    /// Scale of the time-reciprocal feed.
    time_scale: TimeScale, "timeScale", "Speeds", "Time-reciprocal scale", "1", "F is this number divided by the minutes of the block: 1 or 10.";
    /// Values of symbolic feeds.
    symbolic_feeds: BTreeMap<String, f64>, "symbolicFeeds", "Speeds", "Symbolic feeds", "none", "The feed of each symbolic F code.";
    /// Coding of S.
    spindle: SpindleCoding, "spindle", "Speeds", "Spindle speed coding", "direct; ISO 1058: by the digits of S", "How an S word says the spindle speed (annex A).";
    /// Values of symbolic speeds.
    symbolic_speeds: BTreeMap<String, f64>, "symbolicSpeeds", "Speeds", "Symbolic spindle speeds", "none", "The speed of each symbolic S code.";
    /// Places by which the geometric table is moved left.
    decimal_shift: u8, "decimalShift", "Speeds", "Decimal shift of the geometric table", "0", "Places by which the values of the geometric table are moved left (ISO 1058 A.2.3).";
    /// Rapid traverse.
    rapid: Positive, "rapid", "Speeds", "Rapid traverse per minute", "not known", "The speed of G00. While it is not stated, no time is known for rapid moves.";
    /// Greatest feed.
    maximum_feed: Positive, "maximumFeed", "Speeds", "Greatest feed per minute", "not stated", "The greatest feed of the machine.";
    /// The word of a dwell.
    dwell: Dwell, "dwell", "Speeds", "Dwell", "not stated", "Which word carries the time of a dwell (G04), and in what unit. While it is not stated, no time is known for a dwell.";

    /// P, Q, R are compensation vectors.
    compensation: bool, "compensation", "Tool", "P, Q, R are compensation vectors", "no: tertiary motions", "Whether P, Q and R carry the unit vector of cutter compensation (clause 5).";
    /// How that vector lies to the path.
    compensation_vector: CompensationVector, "compensationVector", "Tool", "Compensation vector", "normal to the path", "How P, Q and R lie to the start of their span. Clause 5 speaks of derivatives and leaves it to the builder.";
    /// Radius of the cutter.
    cutter_radius: Positive, "cutterRadius", "Tool", "Cutter radius", "not stated", "Where it is stated, the path of the cutter's centre is drawn beside the programmed one, wherever G41, G42 or P, Q and R are in force. Lengths and times stay those of the programmed path.";
    /// Digits of T that select the compensation.
    compensation_digits: u8, "compensationDigits", "Tool", "Compensation digits of T", "none", "The last digits of T that select the tool compensation (3.3.4.5); the registers show them.";

    /// Meanings that the builder gave.
    declared: Declared, "declared", "Declared meanings", "Declared codes and letters", "none", "Codes and letters to which the builder gave a meaning.";
}
