//! Tapes to begin with, each under its format.

use crate::format::{ArcCentre, ArcFeed, Dimensions, FeedCoding, Format, Itemized, SetPoint, Standard, TapeCode};

/// A tape with its format and what it teaches.
#[derive(Clone, Debug)]
pub struct Preset {
    /// A name that never changes.
    pub id: &'static str,
    /// What it is called.
    pub title: &'static str,
    /// What it teaches, in two sentences.
    pub about: &'static str,
    /// The format that it is read against.
    pub format: Format,
    /// The text.
    pub source: &'static str,
    /// The byte of the text where the cursor stands when it opens.
    pub cursor: usize,
}

/// All presets; the first is shown on a first visit.
pub fn all() -> Vec<Preset> {
    vec![annex_e_circular(), annex_e_parabolic(), y_1702_block()]
}

/// The circular tape of ISO 2539 annex E.
fn annex_e_circular() -> Preset {
    let source = include_str!("annex-e-circular.tape");
    Preset {
        id: "annex-e-circular",
        title: "Annex E, circular",
        about: "The circular tape of ISO 2539 annex E: incremental dimensions, three arcs by centre, feed as the \
                reciprocal of time. Its I, J and K are start minus centre, the other way round than the standard's own \
                figure 2.",
        format: Format {
            standard: Standard::Iso2539,
            classification: Some("CSM 333".to_owned()),
            detail: "N3.G2.XD33.YD33.ZD33.ID33.JD33.F4.M2*".to_owned(),
            itemized: Itemized {
                set_point: Some(SetPoint::InOrder(vec![10.0, 10.0, 20.0])),
                arc_centre: Some(ArcCentre::ToStart),
                feed: Some(FeedCoding::TimeReciprocal),
                arc_feed: Some(ArcFeed::Time),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("G02").unwrap_or(0),
    }
}

/// The parabolic tape of ISO 2539 annex E.
fn annex_e_parabolic() -> Preset {
    let source = include_str!("annex-e-parabolic.tape");
    Preset {
        id: "annex-e-parabolic",
        title: "Annex E, parabolic",
        about: "The parabolic tape of ISO 2539 annex E: the same contour in absolute dimensions, its arcs replaced by \
                five parabolas of two blocks each, with the feed in mm/min. N012 to N014 fit a centre that is 0,005 \
                off: a slip of the printed standard.",
        format: Format {
            standard: Standard::Iso2539,
            classification: Some("CSM 333".to_owned()),
            detail: "N3.G2.X33.Y33.Z33.F4.M2*".to_owned(),
            itemized: Itemized {
                set_point: Some(SetPoint::InOrder(vec![10.0, 10.0, 20.0])),
                feed: Some(FeedCoding::Direct),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("G06").unwrap_or(0),
    }
}

/// The block of Y-1702, page 11.
fn y_1702_block() -> Preset {
    let source = include_str!("y-1702-block.tape");
    Preset {
        id: "y-1702-block",
        title: "Y-1702, one block in EIA code",
        about: "The block that the Y-12 report of 1969 explains word by word, in EIA RS-244: departures in inches, with \
                no decimal point on the tape. Its block 25 is the report's; the second block only ends the program.",
        format: Format {
            standard: Standard::Rs274,
            classification: Some("c23.313.22".to_owned()),
            detail: "n3 g2 x+14 y+14 f21 m2*".to_owned(),
            itemized: Itemized {
                code: Some(TapeCode::Eia),
                dimensions: Some(Dimensions::Incremental),
                feed: Some(FeedCoding::Direct),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("x-").unwrap_or(0),
    }
}
