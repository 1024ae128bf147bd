//! One speed under every method of annex A, and one code: for a reader who wants to compare them.

use super::{BadCode, Code, Coding, NoCode, Speed, reciprocal};
use crate::format::{ArcFeed, Control, FeedCoding, FeedUnit, Unit};

/// What the methods are compared for.
#[derive(Clone, Debug)]
pub struct Comparison {
    control: Control,
    feed: bool,
    /// Length of the block, in the unit of the format: the reciprocal of time needs it.
    pub length: Option<f64>,
    /// Radius of the arc, in the unit of the format: the radians per minute of A.1.2 need it.
    pub radius: Option<f64>,
}

/// One method.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// Which.
    pub method: FeedCoding,
    /// The method in words.
    pub title: String,
    /// Where it is printed.
    pub clause: &'static str,
    /// The word's coding in the format.
    pub in_force: bool,
    /// The code with its digits; `None` where the speed has none.
    pub code: Option<String>,
    /// What that code says; `None` where it says no speed.
    pub speed: Option<f64>,
    /// How far that is above the speed that was asked for, in per cent.
    pub deviation: Option<f64>,
    /// The code says rapid traverse.
    pub rapid: bool,
    /// Why there is no code or no speed; else empty.
    pub note: String,
}

/// Digits of a code where the format has none: those of annex E.
const DIGITS: u16 = 4;

impl Comparison {
    /// For the F words of a control, or for its S words.
    pub fn new(control: Control, feed: bool) -> Comparison {
        Comparison { control, feed, length: None, radius: None }
    }

    /// What the speeds are counted in: "mm/min", "inch/rev", "rev/min".
    pub fn unit(&self) -> &'static str {
        match (self.feed, self.control.unit, self.control.feed_unit) {
            (false, ..) => "rev/min",
            (true, Unit::Millimetre, FeedUnit::PerMinute) => "mm/min",
            (true, Unit::Millimetre, FeedUnit::PerRevolution) => "mm/rev",
            (true, Unit::Inch, FeedUnit::PerMinute) => "inch/min",
            (true, Unit::Inch, FeedUnit::PerRevolution) => "inch/rev",
        }
    }

    fn address(&self) -> u8 {
        if self.feed { b'F' } else { b'S' }
    }

    /// The methods, each with its digits and, of the reciprocal of time, whether it is that on arcs; `written` is how
    /// many digits a code has that is to be read.
    fn methods(&self, written: Option<u16>) -> Vec<(Coding<'_>, bool)> {
        let own = Coding::of(&self.control, self.address());
        let with = |method: FeedCoding, digits: u16| {
            let places = if method == own.method { own.places } else { 0 };
            Coding { method, digits: written.unwrap_or(digits), places, ..own }
        };
        let width = |method| if own.method == method && own.digits > 0 { own.digits } else { DIGITS };
        let mut methods = Vec::new();
        if self.feed {
            let reciprocal = with(FeedCoding::TimeReciprocal, width(FeedCoding::TimeReciprocal));
            methods.extend([(reciprocal, false), (reciprocal, true)]);
        }
        match written {
            Some(digits) => methods.push((with(FeedCoding::Arithmetic, digits), false)),
            None => methods.extend((3..=5).map(|digits| (with(FeedCoding::Arithmetic, digits), false))),
        }
        methods.push((with(FeedCoding::Geometric, 2), false));
        methods
            .push((with(FeedCoding::Symbolic, if own.method == FeedCoding::Symbolic { own.digits } else { 1 }), false));
        methods.push((with(FeedCoding::Direct, width(FeedCoding::Direct)), false));
        methods
    }

    /// By which a rate per minute makes a speed; `None` where the block's measure is not given.
    fn base(&self, method: FeedCoding, arc: bool) -> Option<f64> {
        match (method, arc) {
            (FeedCoding::TimeReciprocal, false) => self.length,
            (FeedCoding::TimeReciprocal, true) => {
                self.radius.map(|radius| reciprocal::base(0.0, Some(radius), ArcFeed::Radians))
            }
            _ => Some(1.0),
        }
        .filter(|base| base.is_finite() && *base > 0.0)
    }

    /// The code of a speed by each method.
    pub fn codes(&self, speed: f64) -> Vec<Compared> {
        let compare = |(coding, arc): (Coding<'_>, bool)| {
            let mut row = self.row(&coding, arc);
            let Some(base) = self.base(coding.method, arc) else { return row };
            match coding.encode(speed / base) {
                Err(reason) => row.note = self.no_code(reason, base),
                Ok(code) => {
                    row.code = Some(code.to_string());
                    row.speed = coding.decode(code).ok().and_then(Speed::number).map(|said| said * base);
                    let off = row.speed.filter(|_| speed > 0.0).map(|said| (said - speed) / speed * 100.0);
                    row.deviation = off.filter(|off| off.is_finite());
                }
            }
            row
        };
        self.methods(None).into_iter().map(compare).collect()
    }

    /// What a code says by each method; `None` where it is no row of digits.
    pub fn speeds(&self, written: &str) -> Option<Vec<Compared>> {
        let digits = u16::try_from(written.len()).ok().filter(|digits| (1..=18).contains(digits))?;
        let number = written.parse().ok().filter(|_| written.bytes().all(|digit| digit.is_ascii_digit()))?;
        let compare = |(coding, arc): (Coding<'_>, bool)| {
            let mut row = self.row(&coding, arc);
            row.code = Some(written.to_owned());
            let Some(base) = self.base(coding.method, arc) else { return row };
            let wrong_digits = coding.method == FeedCoding::Geometric && digits != 2;
            match coding.decode(Code { number, digits }) {
                _ if wrong_digits => row.note = bad_code(BadCode::Digits, coding.method),
                Ok(Speed::Is(said)) => row.speed = Some(said * base).filter(|said| said.is_finite()),
                Ok(Speed::Rapid) if self.feed => {
                    row.rapid = true;
                    row.note = "Rapid traverse: as fast as the machine moves.".to_owned();
                }
                Ok(Speed::Rapid) => row.note = "Rapid traverse, which no spindle has.".to_owned(),
                Err(reason) => row.note = bad_code(reason, coding.method),
            }
            row
        };
        Some(self.methods(Some(digits)).into_iter().map(compare).collect())
    }

    /// A row without what is said of the speed.
    fn row(&self, coding: &Coding<'_>, arc: bool) -> Compared {
        let (title, clause) = match (coding.method, arc) {
            (FeedCoding::TimeReciprocal, false) => ("Reciprocal of time".to_owned(), "ISO 2539 A.1.1"),
            (FeedCoding::TimeReciprocal, true) => ("Radians per minute, on an arc".to_owned(), "ISO 2539 A.1.2"),
            (FeedCoding::Arithmetic, _) => {
                (format!("Arithmetic, {} digits", coding.digits), "ISO 2539 A.2, ISO 1058 A.1")
            }
            (FeedCoding::Geometric, _) if coding.shift > 0 => {
                (format!("Geometric, moved left by {}", coding.shift), "ISO 2539 A.3, ISO 1058 A.2")
            }
            (FeedCoding::Geometric, _) => ("Geometric".to_owned(), "ISO 2539 A.3, ISO 1058 A.2"),
            (FeedCoding::Symbolic, _) => ("Symbolic".to_owned(), "ISO 1058 A.3"),
            (FeedCoding::Direct, _) => ("Direct".to_owned(), "ISO 2539 3.3.4.3"),
        };
        let own = Coding::of(&self.control, self.address());
        let fits = coding.method != FeedCoding::Arithmetic || coding.digits == own.digits;
        let in_radians = self.control.arc_feed == ArcFeed::Radians;
        let measure = if arc { "the radius of the arc" } else { "the length of the block" };
        Compared {
            method: coding.method,
            title,
            clause,
            in_force: own.digits > 0 && coding.method == own.method && fits && (!arc || in_radians),
            code: None,
            speed: None,
            deviation: None,
            rapid: false,
            note: match self.base(coding.method, arc) {
                Some(_) => String::new(),
                None => format!("Give {measure}."),
            },
        }
    }

    fn no_code(&self, reason: NoCode, base: f64) -> String {
        let said = |speed: f64| format!("{} {}", plain(speed * base), self.unit());
        match reason {
            NoCode::Below(least) => format!("The least that it says is {}.", said(least)),
            NoCode::Above(most) => format!("The greatest that it says is {}.", said(most)),
            NoCode::NoTable => {
                let field = if self.feed { "symbolicFeeds" } else { "symbolicSpeeds" };
                format!("The format has no table of values ({field}).")
            }
            NoCode::Digits => "There is no such code.".to_owned(),
            NoCode::NotASpeed => "A speed is a number of zero or more.".to_owned(),
        }
    }
}

fn bad_code(reason: BadCode, method: FeedCoding) -> String {
    match (reason, method) {
        (BadCode::Unlisted, _) => "The format gives this code no value.".to_owned(),
        (BadCode::SecondDigitZero, _) => "The second digit is zero only where all are.".to_owned(),
        (BadCode::Digits, FeedCoding::Geometric) => "It has two digits.".to_owned(),
        (BadCode::Digits, _) => "It has three, four or five digits.".to_owned(),
    }
}

/// A number with six figures at most, without zeros at its end.
fn plain(number: f64) -> String {
    let places = if number >= 1000.0 {
        1
    } else if number >= 1.0 {
        3
    } else {
        6
    };
    let text = format!("{number:.places$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
