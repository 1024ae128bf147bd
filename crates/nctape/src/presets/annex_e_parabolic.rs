//! The parabolic tape of ISO 2539 annex E.

use super::{Preset, PresetKind};
use crate::format::{FeedCoding, Format, Itemized, SetPoint, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("annex-e-parabolic.tape");
    Preset {
        id: "annex-e-parabolic",
        title: "Annex E, parabolic",
        about: "The parabolic tape of ISO 2539 annex E: the same contour in absolute dimensions, its arcs replaced by \
                five parabolas of two blocks each, with the feed in mm/min. N012 to N014 fit a centre that is 0,005 \
                off: a slip of the printed standard.",
        kind: PresetKind::Tape,
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
