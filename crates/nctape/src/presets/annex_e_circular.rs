//! The circular tape of ISO 2539 annex E.

use super::{Preset, PresetKind};
use crate::format::{ArcCentre, ArcFeed, FeedCoding, Format, Itemized, SetPoint, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("annex-e-circular.tape");
    Preset {
        id: "annex-e-circular",
        title: "Annex E, circular",
        about: "The circular tape of ISO 2539 annex E: incremental dimensions, three arcs by centre, feed as the \
                reciprocal of time. Its I, J and K are start minus centre, the other way round than the standard's own \
                figure 2.",
        kind: PresetKind::Tape,
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
