//! Random tapes whose every motion is sound: lines, arcs in three planes, helices, full circles, parabolas, arcs through
//! three points, under many formats.

#[path = "numbers.rs"]
pub mod numbers;

use nctape::format::value::Positive;
use nctape::format::{
    ArcCentre, ArcFeed, Dimensions, FeedCoding, FeedUnit, Format, Itemized, Plane, SetPoint, Standard, TimeScale,
};
use numbers::Numbers;
use std::fmt::Write;

/// A tape with its format.
pub struct RandomTape {
    pub format: Format,
    pub source: String,
}

/// The tape of a number: always the same.
pub fn random_tape(number: u64) -> RandomTape {
    let mut numbers = Numbers::new(0x6E63_7461_7065_0000 ^ number);
    let format = format(&mut numbers);
    let incremental = format.itemized.dimensions == Some(Dimensions::Incremental);
    let mut writer = Writer {
        plane: format.itemized.plane.unwrap_or(Plane::Xy),
        format,
        numbers,
        incremental,
        at: [0; 3],
        text: "%\n".to_owned(),
        block: 0,
        skippable: false,
    };
    writer.start();
    for _ in 0..12 + writer.numbers.below(20) {
        writer.block();
    }
    writer.put("M30");
    RandomTape { format: writer.format, source: writer.text }
}

/// Millimetres with two or three places, or inches with four; every coding of the feed.
fn format(numbers: &mut Numbers) -> Format {
    let (standard, classification, lengths) = numbers.one_of(&[
        (Standard::Iso2539, Some("CSM 333"), "X@43Y@43Z@43I@43J@43K@43"),
        (Standard::Iso2539, Some("CSM 333"), "X@52Y@52Z@52I@52J@52K@52"),
        (Standard::Iso2539, Some("CSI 333"), "X@34Y@34Z@34I@34J@34K@34"),
        (Standard::Rs274, None, "X@34Y@34Z@34I@34J@34K@34"),
    ]);
    let kind = if standard == Standard::Rs274 { "+" } else { "L" };
    let (feed, digits) = numbers.one_of(&[
        (FeedCoding::Direct, 4),
        (FeedCoding::TimeReciprocal, 4),
        (FeedCoding::Arithmetic, 4),
        (FeedCoding::Geometric, 2),
    ]);
    let detail = format!("N4G2{}F{digits}S4T2M2*", lengths.replace('@', kind));
    let dimensions = numbers.one_of(&[Dimensions::Absolute, Dimensions::Incremental]);
    let per_revolution = feed != FeedCoding::TimeReciprocal && numbers.below(3) == 0;
    let start = [0; 3].map(|_: i32| numbers.below(40) as f64);
    Format {
        standard,
        classification: classification.map(str::to_owned),
        detail: if standard == Standard::Rs274 { detail.to_lowercase() } else { detail },
        itemized: Itemized {
            dimensions: Some(dimensions),
            set_point: Some(SetPoint::InOrder(start.to_vec())),
            plane: Some(numbers.one_of(&[Plane::Xy, Plane::Zx, Plane::Yz])),
            arc_centre: Some(numbers.one_of(&[
                ArcCentre::AsDimensions,
                ArcCentre::FromStart,
                ArcCentre::ToStart,
                ArcCentre::Absolute,
            ])),
            helix: Some(true),
            full_circle: Some(true),
            feed: Some(feed),
            feed_unit: Some(if per_revolution { FeedUnit::PerRevolution } else { FeedUnit::PerMinute }),
            arc_feed: Some(numbers.one_of(&[ArcFeed::Radians, ArcFeed::Time])),
            time_scale: Some(TimeScale(numbers.one_of(&[1, 10]))),
            rapid: Some(Positive(5000.0)),
            ..Itemized::default()
        },
    }
}

struct Writer {
    format: Format,
    numbers: Numbers,
    plane: Plane,
    incremental: bool,
    /// Where the tool stands, in increments.
    at: [i64; 3],
    text: String,
    block: usize,
    /// The block can be skipped.
    skippable: bool,
}

impl Writer {
    fn places(&self) -> u32 {
        if self.format.detail.contains("52") {
            2
        } else if self.format.detail.contains("34") {
            4
        } else {
            3
        }
    }

    fn put(&mut self, words: &str) {
        self.block += 1;
        let skip = if self.skippable { "/" } else { "" };
        let line = format!("{skip}N{:04} {words}\n", self.block);
        self.text.push_str(&if self.format.standard == Standard::Rs274 { line.to_lowercase() } else { line });
    }

    fn start(&mut self) {
        let unit = 10_i64.pow(self.places());
        if let Some(SetPoint::InOrder(numbers)) = &self.format.itemized.set_point {
            self.at = std::array::from_fn(|axis| numbers[axis] as i64 * unit);
        }
        self.put("T01 M06");
        let feed = self.feed();
        self.put(&format!("S0600 M03{feed}"));
    }

    /// An F word by the coding of the format.
    fn feed(&mut self) -> String {
        match self.format.itemized.feed {
            Some(FeedCoding::Geometric) => format!(" F{:02}", 1 + self.numbers.below(98)),
            Some(FeedCoding::Arithmetic) => format!(" F{}{}", self.numbers.below(9), 100 + self.numbers.below(900)),
            _ => format!(" F{:04}", 1 + self.numbers.below(900)),
        }
    }

    /// An F word, where the block needs one of its own or changes it.
    fn own_feed(&mut self) -> String {
        let own = self.format.itemized.feed == Some(FeedCoding::TimeReciprocal);
        if own || self.numbers.below(3) == 0 { self.feed() } else { String::new() }
    }

    /// A length in increments: up to some units either way.
    fn length(&mut self, units: i64) -> i64 {
        let most = units * 10_i64.pow(self.places());
        self.numbers.below(2 * most as usize + 1) as i64 - most
    }

    fn block(&mut self) {
        match self.numbers.below(12) {
            0 => return self.dimensions(),
            1 => return self.turn_plane(),
            2 => return self.put(["M08", "M09", "M01", "M05", "M03", "G04"][self.block % 5]),
            _ => {}
        }
        // Absolute dimensions do not mind that a block is skipped, if the next one names every axis.
        self.skippable = !self.incremental && self.numbers.below(12) == 0;
        match self.numbers.below(9) {
            0 => self.straight("G00"),
            1 | 2 => self.straight("G01"),
            3 | 4 => self.arc(false),
            5 => self.arc(true),
            6 => self.three_points(),
            7 => self.parabola(true),
            _ => self.parabola(false),
        }
        self.skippable = false;
    }

    fn dimensions(&mut self) {
        self.incremental = !self.incremental;
        self.put(if self.incremental { "G91" } else { "G90" });
    }

    fn turn_plane(&mut self) {
        self.plane = self.numbers.one_of(&[Plane::Xy, Plane::Zx, Plane::Yz]);
        let code = [(Plane::Xy, "G17"), (Plane::Zx, "G18"), (Plane::Yz, "G19")];
        let (_, code) = code.into_iter().find(|(plane, _)| *plane == self.plane).unwrap_or(code[0]);
        self.put(code);
    }

    /// Dimension words of some axes to a point, and moves there.
    fn go(&mut self, to: [i64; 3], axes: &[usize]) -> String {
        let mut words = String::new();
        for axis in 0..3 {
            if axes.contains(&axis) {
                let value = if self.incremental { to[axis] - self.at[axis] } else { to[axis] };
                write!(words, " {}{}", ["X", "Y", "Z"][axis], self.digits(value)).unwrap();
                self.at[axis] = to[axis];
            }
        }
        words
    }

    /// I, J and K for a point, by the reading of the format.
    fn parameters(&self, point: [i64; 3], start: [i64; 3], axes: &[usize]) -> String {
        let reading = match (self.format.itemized.arc_centre, self.incremental) {
            (Some(ArcCentre::AsDimensions), true) => ArcCentre::FromStart,
            (Some(ArcCentre::AsDimensions), false) => ArcCentre::Absolute,
            (other, _) => other.unwrap_or(ArcCentre::FromStart),
        };
        let mut words = String::new();
        for axis in (0..3).filter(|axis| axes.contains(axis)) {
            let value = match reading {
                ArcCentre::Absolute => point[axis],
                ArcCentre::ToStart => start[axis] - point[axis],
                _ => point[axis] - start[axis],
            };
            write!(words, " {}{}", ["I", "J", "K"][axis], self.digits(value)).unwrap();
        }
        words
    }

    fn digits(&self, value: i64) -> String {
        format!("{}{:07}", if value < 0 { '-' } else { '+' }, value.abs())
    }

    /// Keeps the tool within a cube of 200 units.
    fn near(&mut self) -> [i64; 3] {
        std::array::from_fn(|_| self.length(100))
    }

    fn straight(&mut self, code: &str) {
        let to = self.near();
        let axes: Vec<usize> =
            if self.skippable { vec![0, 1, 2] } else { (0..3).filter(|_| self.numbers.below(2) == 0).collect() };
        let axes = if axes.is_empty() { vec![0] } else { axes };
        let words = self.go(to, &axes);
        let feed = if code == "G01" { self.own_feed() } else { String::new() };
        self.put(&format!("{code}{words}{feed}"));
    }

    /// A point at an angle about a centre, rounded to increments.
    fn on_circle(&self, centre: [i64; 2], radius: f64, angle: f64) -> [i64; 2] {
        [centre[0] + (radius * libm::cos(angle)).round() as i64, centre[1] + (radius * libm::sin(angle)).round() as i64]
    }

    fn arc(&mut self, helix: bool) {
        let [first, second, third] = self.plane.axes();
        let start = self.at;
        let centre = [start[first] + self.length(30), start[second] + self.length(30)];
        let from = [(start[first] - centre[0]) as f64, (start[second] - centre[1]) as f64];
        let radius = libm::hypot(from[0], from[1]);
        if radius < 0.5 * 10_i64.pow(self.places()) as f64 {
            return;
        }
        let full = self.numbers.below(8) == 0;
        let angle = libm::atan2(from[1], from[0]) + 0.2 + self.numbers.below(580) as f64 / 100.0;
        let end = if full { [start[first], start[second]] } else { self.on_circle(centre, radius, angle) };
        let mut to = start;
        (to[first], to[second]) = (end[0], end[1]);
        let mut axes = vec![first, second];
        if helix {
            to[third] += self.length(10);
            axes.push(third);
        }
        let mut point = start;
        (point[first], point[second]) = (centre[0], centre[1]);
        let code = self.numbers.one_of(&["G02", "G03"]);
        if self.skippable {
            axes = vec![0, 1, 2];
        }
        let words = self.go(to, &axes);
        let parameters = self.parameters(point, start, &[first, second]);
        let feed = self.own_feed();
        self.put(&format!("{code}{words}{parameters}{feed}"));
    }

    /// An arc by an intermediate point, in two blocks.
    fn three_points(&mut self) {
        if self.skippable {
            return;
        }
        let [first, second, _] = self.plane.axes();
        let start = self.at;
        let centre = [start[first] + self.length(40), start[second] + self.length(40)];
        let from = [(start[first] - centre[0]) as f64, (start[second] - centre[1]) as f64];
        let radius = libm::hypot(from[0], from[1]);
        if radius < 5.0 * 10_i64.pow(self.places()) as f64 {
            return;
        }
        let turn = 0.5 + self.numbers.below(450) as f64 / 100.0;
        let clockwise = self.numbers.below(2) == 0;
        let turn = if clockwise { -turn } else { turn };
        let angle = libm::atan2(from[1], from[0]);
        let code = if clockwise { "G02" } else { "G03" };
        for part in [turn / 2.0, turn] {
            let point = self.on_circle(centre, radius, angle + part);
            let mut to = self.at;
            (to[first], to[second]) = (point[0], point[1]);
            let words = self.go(to, &[first, second]);
            let feed = self.own_feed();
            self.put(&format!("{code}{words}{feed}"));
        }
    }

    /// A parabola by its tangent intersection point: in XY, or anywhere in space.
    fn parabola(&mut self, flat: bool) {
        let start = self.at;
        let axes: Vec<usize> = if flat { vec![0, 1] } else { vec![0, 1, 2] };
        let near = |writer: &mut Writer| -> [i64; 3] {
            std::array::from_fn(|axis| if axes.contains(&axis) { start[axis] + writer.length(25) } else { start[axis] })
        };
        let (to, tangent) = (near(self), near(self));
        // Apart, and off the chord: else it is no parabola.
        let cross: f64 = {
            let side = |at: [i64; 3]| [0, 1].map(|axis| (at[axis] - start[axis]) as f64);
            let (end, corner) = (side(to), side(tangent));
            end[0] * corner[1] - end[1] * corner[0]
        };
        if cross.abs() < 25.0 * 10_i64.pow(2 * self.places()) as f64 {
            return;
        }
        let words = self.go(to, if self.skippable { &[0, 1, 2] } else { &axes });
        let parameters = self.parameters(tangent, start, &axes);
        let feed = self.own_feed();
        self.put(&format!("G06{words}{parameters}{feed}"));
    }
}
