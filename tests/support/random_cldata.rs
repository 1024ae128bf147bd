//! Random CLDATA of points and arcs, with a format to post it to: the same in every run.

use super::numbers::Numbers;
use nctape::format::{
    ArcCentre, ArcFeed, Dimensions, FeedCoding, Format, Itemized, Plane, Standard, TapeCode, TimeScale,
};
use nctape::post::{Arcs, Options};
use std::f64::consts::TAU;
use std::fmt::Write;

/// A text with a format, and how it is posted to that.
pub struct RandomCldata {
    pub source: String,
    pub format: Format,
    pub options: Options,
    /// The least input increment of the format in millimetres, or in inches.
    pub increment: f64,
}

/// The text of a number: always the same.
pub fn random_cldata(number: u64) -> RandomCldata {
    let mut numbers = Numbers::new(0x636C_6461_7461_0000 ^ number);
    let (format, increment) = format(&mut numbers);
    let is_inch = format.standard == Standard::Rs274 || format.classification.as_deref() == Some("CSI 333");
    let arcs = numbers.one_of(&[Arcs::Circles, Arcs::Circles, Arcs::Circles, Arcs::Parabolas, Arcs::Chords]);
    let tolerance = increment * (1 + numbers.below(40)) as f64;
    let options = Options {
        arcs: Some(arcs),
        tolerance: Some(tolerance),
        quadrants: numbers.below(4) == 0,
        ..Options::default()
    };
    let mut writer = Writer {
        helix: format.itemized.helix == Some(true) || arcs != Arcs::Circles,
        scale: if is_inch { 0.04 } else { 1.0 },
        numbers,
        at: [0.0; 3],
        text: String::new(),
        records: 0,
        cutter: 0.0,
    };
    writer.file(is_inch);
    RandomCldata { source: writer.text, format, options, increment }
}

/// Millimetres with two to four places, or inches with four or five; every reading of I, J and K, both kinds of
/// dimensions, both codes, every coding of the feed but the symbolic one.
fn format(numbers: &mut Numbers) -> (Format, f64) {
    let (standard, classification, places, before) = numbers.one_of(&[
        (Standard::Iso2539, Some("CSM 333"), 2, 5),
        (Standard::Iso2539, Some("CSM 333"), 3, 4),
        (Standard::Iso2539, Some("CSM 333"), 4, 4),
        (Standard::Iso2539, Some("CSI 333"), 4, 3),
        (Standard::Rs274, None, 5, 3),
    ]);
    let sign = if standard == Standard::Rs274 { "+" } else { "L" };
    let lengths: String =
        ["X", "Y", "Z", "I", "J", "K"].map(|letter| format!("{letter}{sign}{before}{places}")).concat();
    let (feed, digits) = numbers.one_of(&[
        (FeedCoding::Direct, "5"),
        (FeedCoding::TimeReciprocal, "7"),
        (FeedCoding::Arithmetic, "4"),
        (FeedCoding::Geometric, "2"),
    ]);
    let detail = format!("N4G2{lengths}F{digits}S4T2M2*");
    let itemized = Itemized {
        code: Some(numbers.one_of(&[TapeCode::Iso, TapeCode::Eia])),
        dimensions: Some(numbers.one_of(&[Dimensions::Absolute, Dimensions::Incremental])),
        plane: Some(numbers.one_of(&[Plane::Xy, Plane::Zx, Plane::Yz])),
        arc_centre: Some(numbers.one_of(&[
            ArcCentre::AsDimensions,
            ArcCentre::FromStart,
            ArcCentre::ToStart,
            ArcCentre::Absolute,
            ArcCentre::Quadrant,
        ])),
        helix: Some(numbers.below(2) == 0),
        full_circle: Some(numbers.below(2) == 0),
        feed: Some(feed),
        arc_feed: Some(numbers.one_of(&[ArcFeed::Radians, ArcFeed::Time])),
        time_scale: Some(TimeScale(numbers.one_of(&[1, 10]))),
        ..Itemized::default()
    };
    let detail = if standard == Standard::Rs274 { detail.to_lowercase() } else { detail };
    let classification = classification.map(str::to_owned);
    let mut increment = 1.0;
    (0..places).for_each(|_| increment /= 10.0);
    (Format { standard, classification, detail, itemized }, increment)
}

struct Writer {
    numbers: Numbers,
    /// The third axis of an arc moves now and then.
    helix: bool,
    /// A millimetre in the unit of the text, in round numbers.
    scale: f64,
    at: [f64; 3],
    text: String,
    records: usize,
    cutter: f64,
}

impl Writer {
    fn record(&mut self, elements: &str) {
        self.records += 1;
        writeln!(self.text, "{},{elements};", self.records).unwrap();
    }

    /// A number from -1 to 1.
    fn share(&mut self) -> f64 {
        self.numbers.below(2_000_001) as f64 / 1e6 - 1.0
    }

    fn file(&mut self, is_inch: bool) {
        self.record(if is_inch { "9000,9,3" } else { "9000,9,1" });
        self.cutter = 8.0 * self.scale;
        let cutter = self.cutter;
        self.record(&format!("6000,6,{cutter:?}"));
        self.record("20000,0,SPINDL,RPM,600.,CLW");
        let start = [0; 3].map(|_: i32| (self.share() * 50.0).round() * self.scale);
        self.at = start;
        self.points("3", &[start]);
        self.feed();
        for _ in 0..10 + self.numbers.below(15) {
            match self.numbers.below(8) {
                0 => self.feed(),
                1 => {
                    self.record("20000,0,RAPID");
                    self.straight();
                }
                2 | 3 => self.straight(),
                _ => self.arc(),
            }
        }
        self.record("20000,0,END");
        self.record("14000");
        self.text.push_str(":\n");
    }

    fn feed(&mut self) {
        let feed = (200 + self.numbers.below(900)) as f64 * self.scale;
        self.record(&format!("20000,0,FEDRAT,{feed:?},PERMIN"));
    }

    fn points(&mut self, subtype: &str, points: &[[f64; 3]]) {
        let reals: Vec<String> = points.iter().flatten().map(|value| format!("{value:.9}")).collect();
        self.record(&format!("5000,{subtype},'',0,{}", reals.join(",")));
    }

    fn straight(&mut self) {
        let scale = self.scale;
        let count = 1 + self.numbers.below(3);
        let mut points = Vec::new();
        for _ in 0..count {
            for axis in 0..3 {
                // Along one axis, two, or all; at least a tenth, which is more than any increment.
                if self.numbers.below(3) > 0 || axis == 0 {
                    let way = self.share() * 60.0 * scale;
                    self.at[axis] += way + 0.1 * scale * way.signum();
                }
            }
            points.push(self.at);
        }
        self.points("5", &points);
    }

    /// An arc in a principal plane, in the custom of the path or in that of the part.
    fn arc(&mut self) {
        let third = self.numbers.below(3);
        let (first, second) = ((third + 1) % 3, (third + 2) % 3);
        let radius = (5.0 + 20.0 * self.share().abs()) * self.scale;
        let from = self.share() * TAU;
        let full = self.numbers.below(8) == 0;
        let sign = if self.share() < 0.0 { -1.0 } else { 1.0 };
        let sweep = if full { TAU } else { 0.05 + self.share().abs() * 6.1 } * sign;
        let start = self.at;
        let mut centre = start;
        centre[first] -= radius * libm::cos(from);
        centre[second] -= radius * libm::sin(from);
        let rise = if self.helix && self.numbers.below(3) == 0 { self.share() * 10.0 * self.scale } else { 0.0 };
        let at = |share: f64| {
            let mut point = start;
            let angle = from + share * sweep;
            point[first] = centre[first] + radius * libm::cos(angle);
            point[second] = centre[second] + radius * libm::sin(angle);
            point[third] += share * rise;
            point
        };
        let of_part = self.numbers.below(2) == 0;
        let mut axis = [0.0; 3];
        axis[third] = if of_part { 1.0 } else { sign };
        let written = if of_part { radius - self.cutter / 2.0 } else { radius };
        let reals: Vec<String> =
            centre.iter().chain(&axis).chain([&written]).map(|value| format!("{value:.9}")).collect();
        self.record(&format!("3000,2,0,4,9,'C',0,{}", reals.join(",")));
        let end = if full && rise == 0.0 { start } else { at(1.0) };
        let mut points = Vec::new();
        if of_part {
            points.extend((1..8).map(|part| at(f64::from(part) / 8.0)));
        }
        points.push(end);
        self.points("5", &points);
        self.at = end;
    }
}
