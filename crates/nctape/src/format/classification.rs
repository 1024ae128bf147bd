//! Format classification shorthand: annex C of both standards, and the EIA shorthand of Y-1702.

use std::ops::Range;

/// How words are told apart on the tape: C.1.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// A: with addresses, without tabulation.
    Address,
    /// T: with tabulation, without addresses.
    Tab,
    /// S: with addresses and tabulation (ISO 1058), with addresses and optional tabulation (ISO 2539).
    TabAndAddress,
}

impl System {
    /// Its letter.
    pub fn letter(self) -> char {
        match self {
            System::Address => 'A',
            System::Tab => 'T',
            System::TabAndAddress => 'S',
        }
    }
}

/// The unit of linear dimensions: C.1.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// M.
    Millimetre,
    /// I.
    Inch,
}

impl Unit {
    /// "mm" or "inch".
    pub fn name(self) -> &'static str {
        match self {
            Unit::Millimetre => "mm",
            Unit::Inch => "inch",
        }
    }
}

/// The unit of angular dimensions: C.1.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angles {
    /// R: decimal parts of a revolution.
    Turns,
    /// D: degrees.
    Degrees,
}

/// The classification of an ISO format, letter by letter as it was found: [`crate::rules`] judge it.
///
/// ```
/// use nctape::format::{Classification, System};
/// let found = Classification::read("CSM 432");
/// assert_eq!(found.system(), Some(System::TabAndAddress));
/// assert_eq!(found.digits(), Some([4, 3, 2]));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Classification {
    /// The letters before the digits, in upper case, each with its place.
    pub letters: Vec<(char, Range<usize>)>,
    /// Everything behind the letters, blanks left out, each with its place.
    pub rest: Vec<(char, Range<usize>)>,
    /// The length of the text.
    pub length: usize,
}

impl Classification {
    /// Takes a shorthand apart. Blanks are layout.
    pub fn read(text: &str) -> Classification {
        let places = text.char_indices().filter(|(_, c)| !c.is_whitespace());
        let places = places.map(|(at, c)| (c.to_ascii_uppercase(), at..at + c.len_utf8()));
        let (mut letters, mut rest) = (Vec::new(), Vec::new());
        for place in places {
            if rest.is_empty() && place.0.is_alphabetic() {
                letters.push(place);
            } else {
                rest.push(place);
            }
        }
        Classification { letters, rest, length: text.len() }
    }

    /// Nothing is written.
    pub(crate) fn is_empty(&self) -> bool {
        self.letters.is_empty() && self.rest.is_empty()
    }

    fn letter(&self, index: usize) -> Option<char> {
        self.letters.get(index).map(|letter| letter.0)
    }

    /// The second letter.
    pub fn system(&self) -> Option<System> {
        match self.letter(1)? {
            'A' => Some(System::Address),
            'T' => Some(System::Tab),
            'S' => Some(System::TabAndAddress),
            _ => None,
        }
    }

    /// The third letter.
    pub fn unit(&self) -> Option<Unit> {
        match self.letter(2)? {
            'M' => Some(Unit::Millimetre),
            'I' => Some(Unit::Inch),
            _ => None,
        }
    }

    /// The fourth letter.
    pub fn angles(&self) -> Option<Angles> {
        match self.letter(3)? {
            'R' => Some(Angles::Turns),
            'D' => Some(Angles::Degrees),
            _ => None,
        }
    }

    /// The three digits: motions, motions under dimension words, simultaneous motions. `None` unless there are
    /// exactly three.
    pub fn digits(&self) -> Option<[u8; 3]> {
        let digits: Option<Vec<u8>> =
            self.rest.iter().map(|place| place.0.to_digit(10).map(|digit| digit as u8)).collect();
        digits?.try_into().ok()
    }
}

/// The EIA shorthand, "c23.314.22", as it is probably meant.
///
/// Y-1702 explains it in its figure 4, which is lost; the places are read in the order in which a handbook lists what
/// it says. So it never decides anything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shorthand {
    /// The letter, in lower case: c for a contouring control.
    pub system: char,
    /// Words of motions.
    pub motions: u8,
    /// Other words, the sequence number not counted.
    pub others: u8,
    /// The type of the dimensions.
    pub kind: u8,
    /// Digits before the decimal sign.
    pub before: u8,
    /// Digits behind it.
    pub after: u8,
    /// Channels of motion control.
    pub channels: u8,
    /// Axes.
    pub axes: u8,
}

impl Shorthand {
    /// Takes a shorthand apart: a letter, and two, three and two digits with full stops or blanks between them.
    ///
    /// ```
    /// use nctape::format::Shorthand;
    /// let read = Shorthand::read("c23.314.22").unwrap();
    /// assert_eq!((read.motions, read.before, read.after, read.axes), (2, 1, 4, 2));
    /// assert!(Shorthand::read("CSM 432").is_none());
    /// ```
    pub fn read(text: &str) -> Option<Shorthand> {
        let mut places = text.chars().filter(|c| !c.is_whitespace() && *c != '.');
        let system = places.next().filter(char::is_ascii_alphabetic)?.to_ascii_lowercase();
        let digits: Option<Vec<u8>> = places.map(|c| c.to_digit(10).map(|digit| digit as u8)).collect();
        let [motions, others, kind, before, after, channels, axes] = digits?.try_into().ok()?;
        Some(Shorthand { system, motions, others, kind, before, after, channels, axes })
    }
}
