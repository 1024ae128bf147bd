//! The format specification of a control: classification, detail and itemized data (ISO 2539 clause 6, ISO 1058
//! clause 4).
//!
//! [`Format`] is what a person states. [`Control`] is what it makes of reading and executing: every default in place.
//! A format that is itself wrong still makes a control; [`explain`] says what is wrong with it.

mod choice;
mod classification;
mod control;
mod detail;
mod explain;
mod itemized;
pub mod machine;
mod places;
mod reading;
pub mod value;

pub use classification::{Angles, Classification, Shorthand, System, Unit};
pub(crate) use control::power_of_ten;
pub use control::{Axis, Control};
pub(crate) use detail::DIMENSION_LETTERS;
pub use detail::{Designation, Detail, Sign, Zeros};
pub use explain::{Explanation, FormatDiagnostic, explain, explain_read, one_line};
pub use itemized::{
    ArcCentre, ArcFeed, ArcParameters, CompensationVector, CurveKind, Declared, Dimensions, Dwell, DwellUnit,
    FeedCoding, FeedUnit, Itemized, ItemizedField, ParabolaParameters, Plane, SetPoint, SpindleCoding, TapeCode,
    TapeEnd, TimeScale,
};
pub use places::Places;
pub use reading::Malformed;

pub(crate) use choice::choices;

choices! {
    /// The standard that a format follows.
    Standard {
        /// ISO 2539:1974, contouring and contouring/positioning.
        Iso2539 = "iso2539", "ISO 2539";
        /// ISO 1058:1973, positioning and straight-cut machining.
        Iso1058 = "iso1058", "ISO 1058";
        /// EIA RS-274 as Y-1702 describes it.
        Rs274 = "rs274", "EIA RS-274";
    }
}

/// The format specification of a control.
#[derive(Clone, Debug, PartialEq)]
pub struct Format {
    /// The standard that it follows.
    pub standard: Standard,
    /// Format classification shorthand: ISO annex C, "CSM 432", or EIA, "c23.313.22".
    pub classification: Option<String>,
    /// Format classification detailed shorthand: annex D, "N3.G2.X+42*".
    pub detail: String,
    /// What the standard leaves to the builder.
    pub itemized: Itemized,
}

impl Format {
    /// A format with nothing stated but its standard and detail.
    pub fn new(standard: Standard, detail: &str) -> Format {
        Format { standard, classification: None, detail: detail.to_owned(), itemized: Itemized::default() }
    }

    /// The same with a classification.
    pub fn classified(mut self, classification: &str) -> Format {
        self.classification = Some(classification.to_owned());
        self
    }
}
