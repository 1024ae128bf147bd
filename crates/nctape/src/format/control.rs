//! The control that a format describes: every default in place, ready for reading and executing.

use super::{
    Angles, ArcCentre, ArcFeed, ArcParameters, Classification, CompensationVector, Designation, Detail, Dimensions,
    FeedCoding, FeedUnit, Format, ParabolaParameters, Plane, SetPoint, Sign, Standard, System, Unit,
};
use crate::code::{Code, EndOfBlock};
use crate::function::{Preparatory, preparatory};
use crate::speed::method_of_digits;

/// An axis of the report: X, Y and Z first, then the other dimension words of the detail.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Its letter.
    pub letter: char,
    /// Decimal places of its least input increment.
    pub decimals: u8,
    /// How its dimension words are signed; `None` where the detail has no word for it.
    pub sign: Option<Sign>,
}

impl Axis {
    /// It turns: A, B and C, and D and E about special axes. All others are parallel to X, Y and Z (B.1).
    pub(crate) fn is_rotary(&self) -> bool {
        matches!(self.letter, 'A'..='E')
    }
}

/// What a format makes of reading and executing.
#[derive(Clone, Debug)]
pub struct Control {
    /// The format that it was made from.
    pub format: Format,
    /// The classification, taken apart; `None` where there is none or it is EIA's.
    pub classification: Option<Classification>,
    /// The detail, taken apart.
    pub detail: Detail,
    /// How words are told apart.
    pub system: System,
    /// The unit of lengths.
    pub unit: Unit,
    /// The axes, X, Y and Z first.
    pub axes: Vec<Axis>,
    /// The code of the tape.
    pub code: Code,
    /// The end-of-block row in ISO code.
    pub end_of_block: EndOfBlock,
    /// Set point in least input increments, axis by axis.
    pub set_point: Vec<i64>,
    /// Dimensions at the start, where the detail leaves it open.
    pub dimensions: Dimensions,
    /// Plane at the start.
    pub plane: Plane,
    /// What I, J, K say of arcs.
    pub arc_parameters: ArcParameters,
    /// How I, J, K give a point.
    pub arc_centre: ArcCentre,
    /// What I, J, K say of parabolas.
    pub parabola_parameters: ParabolaParameters,
    /// A third axis may move in an arc block.
    pub helix: bool,
    /// Coding of F.
    pub feed: FeedCoding,
    /// Coding of S; never the reciprocal of time.
    pub spindle: FeedCoding,
    /// What the feed is counted against.
    pub feed_unit: FeedUnit,
    /// Time-reciprocal feed on arcs.
    pub arc_feed: ArcFeed,
    /// F is this divided by minutes.
    pub time_scale: f64,
    /// P, Q and R are the vector of cutter compensation.
    pub vectors: bool,
    /// How that vector lies to the path.
    pub compensation_vector: CompensationVector,
    /// The travel of every axis, where it is stated: least and greatest position in the unit of the format.
    pub travel: Vec<Option<(f64, f64)>>,
    simultaneous: Option<u8>,
    /// The G codes under which a curve of higher order runs, bit by bit.
    curves: u128,
    designation_of: [u8; 128],
    axis_of: [u8; 128],
}

const NONE: u8 = u8::MAX;

/// Decimal places of an axis that has no dimension word: enough for any set point that a format states.
const UNWRITTEN_DECIMALS: u8 = 6;

impl Control {
    /// Makes a control of a format, however wrong it is.
    pub fn new(format: &Format) -> Control {
        let standard = format.standard;
        let detail = Detail::read(&format.detail, standard);
        let classification = match standard {
            Standard::Rs274 => None,
            _ => format.classification.as_deref().map(Classification::read),
        };
        let stated = &format.itemized;
        let mut designation_of = [NONE; 128];
        for (index, word) in detail.words.iter().enumerate().take(usize::from(NONE)) {
            let slot = &mut designation_of[word.address as usize & 127];
            // A word that the detail names twice keeps its first designation.
            if *slot == NONE {
                *slot = index as u8;
            }
        }
        let axes = axes(&detail, stated.compensation == Some(true));
        let mut axis_of = [NONE; 128];
        for (index, axis) in axes.iter().enumerate() {
            axis_of[axis.letter as usize & 127] = index as u8;
        }
        let digits = classification.as_ref().and_then(Classification::digits);
        let width =
            |letter: char| detail.words.iter().find(|word| word.address == letter).map_or(0, Designation::width);
        Control {
            system: system(classification.as_ref(), &detail),
            unit: unit(standard, classification.as_ref()),
            code: stated.code.map_or(Code::Iso, Code::from),
            end_of_block: stated.end_of_block.map_or(EndOfBlock::Lf, EndOfBlock::from),
            set_point: set_point(stated.set_point.as_ref(), &axes),
            dimensions: stated.dimensions.unwrap_or(Dimensions::Absolute),
            plane: stated.plane.unwrap_or(Plane::Xy),
            arc_parameters: stated.arc_parameters.unwrap_or(ArcParameters::Centre),
            arc_centre: stated.arc_centre.unwrap_or(ArcCentre::AsDimensions),
            parabola_parameters: stated.parabola_parameters.unwrap_or(ParabolaParameters::Tangent),
            helix: stated.helix.unwrap_or(digits.is_some_and(|digits| digits[2] >= 3)),
            feed: stated.feed.unwrap_or_else(|| method_of_digits(standard, width('F'))),
            spindle: stated.spindle.map_or_else(|| method_of_digits(standard, width('S')), FeedCoding::from),
            feed_unit: stated.feed_unit.unwrap_or(FeedUnit::PerMinute),
            arc_feed: stated.arc_feed.unwrap_or(ArcFeed::Radians),
            time_scale: stated.time_scale.map_or(1.0, |scale| f64::from(scale.0)),
            vectors: stated.compensation == Some(true),
            compensation_vector: stated.compensation_vector.unwrap_or(CompensationVector::Normal),
            travel: axes.iter().map(|axis| stated.travel.as_ref()?.get(&axis.letter.to_string()).copied()).collect(),
            simultaneous: digits.map(|digits| digits[2]),
            curves: stated
                .curves
                .iter()
                .flat_map(|curves| curves.keys())
                .filter_map(|name| curve_code(name))
                .fold(0, |codes, code| codes | 1 << code),
            format: format.clone(),
            classification,
            detail,
            axes,
            designation_of,
            axis_of,
        }
    }

    /// The standard in force.
    pub fn standard(&self) -> Standard {
        self.format.standard
    }

    /// The designation of an address; `None` where the detail lacks it.
    pub fn designation(&self, address: u8) -> Option<&Designation> {
        let index = *self.designation_of.get(usize::from(address))?;
        self.detail.words.get(usize::from(index))
    }

    /// The axis that a dimension word moves, as an index into [`Control::axes`].
    pub fn axis(&self, address: u8) -> Option<usize> {
        let index = *self.axis_of.get(usize::from(address))?;
        (index != NONE).then_some(usize::from(index))
    }

    /// A curve of higher order runs under this G code.
    pub(crate) fn is_curve(&self, code: u8) -> bool {
        code < 100 && self.curves >> code & 1 != 0
    }

    /// Motions that the control carries out at once: the third digit of the classification.
    pub fn simultaneous(&self) -> Option<u8> {
        self.simultaneous
    }

    /// The format states the radius of a cutter, whose centre can be drawn where compensation is in force.
    pub fn compensates(&self) -> bool {
        self.format.itemized.cutter_radius.is_some()
    }

    /// The unit of angular dimensions: degrees where the classification does not say.
    pub fn angles(&self) -> Angles {
        self.classification.as_ref().and_then(Classification::angles).unwrap_or(Angles::Degrees)
    }
}

/// The number of a code such as G05, to which ISO 1056 gives no meaning: an assigned one keeps its own.
fn curve_code(name: &str) -> Option<u8> {
    let digits = name.strip_prefix('G').filter(|digits| digits.len() == 2)?;
    let code: u8 = digits.bytes().all(|digit| digit.is_ascii_digit()).then(|| digits.parse().ok())??;
    (!matches!(preparatory(code), Preparatory::Assigned(..))).then_some(code)
}

/// Ten to the power of a count of decimal places. Exact: 10^18 is the last power below 2^63, and what
/// [`super::Detail`] allows is 9 places.
pub(crate) fn power_of_ten(places: u8) -> i64 {
    const POWERS: [i64; 19] = {
        let mut powers = [1; 19];
        let mut places = 1;
        while places < 19 {
            powers[places] = 10 * powers[places - 1];
            places += 1;
        }
        powers
    };
    POWERS[usize::from(places.min(18))]
}

fn axes(detail: &Detail, compensation: bool) -> Vec<Axis> {
    let of = |letter: char| {
        let word = detail.words.iter().find(|word| word.address == letter && word.dimension);
        Axis { letter, decimals: word.map_or(UNWRITTEN_DECIMALS, |word| word.after), sign: word.map(|word| word.sign) }
    };
    let mut axes: Vec<Axis> = "XYZ".chars().map(of).collect();
    for word in detail.words.iter().filter(|word| word.dimension) {
        let parameter = "IJK".contains(word.address) || compensation && "PQR".contains(word.address);
        if !parameter && !axes.iter().any(|axis| axis.letter == word.address) {
            axes.push(of(word.address));
        }
    }
    axes
}

fn system(classification: Option<&Classification>, detail: &Detail) -> System {
    let by_detail = || {
        if detail.words.iter().any(|word| word.tab) { System::TabAndAddress } else { System::Address }
    };
    classification.and_then(Classification::system).unwrap_or_else(by_detail)
}

/// ISO formats say M or I; without a classification millimetres are assumed. Y-1702's shorthand does not say: its
/// dimensions are inches, as was usual where RS-274 was.
fn unit(standard: Standard, classification: Option<&Classification>) -> Unit {
    let default = if standard == Standard::Rs274 { Unit::Inch } else { Unit::Millimetre };
    classification.and_then(Classification::unit).unwrap_or(default)
}

fn set_point(stated: Option<&SetPoint>, axes: &[Axis]) -> Vec<i64> {
    let of = |index: usize, axis: &Axis| {
        let value = match stated {
            Some(SetPoint::InOrder(numbers)) => numbers.get(index).copied(),
            Some(SetPoint::Named(numbers)) => numbers.get(&axis.letter.to_string()).copied(),
            None => None,
        };
        let increments = value.unwrap_or(0.0) * power_of_ten(axis.decimals) as f64;
        // `as` saturates; what is beyond i64 is beyond any word, and is reported where it is used.
        increments.round() as i64
    };
    axes.iter().enumerate().map(|(index, axis)| of(index, axis)).collect()
}
