//! A boring machine with the format of ISO 2539 annex D.

use super::{Preset, PresetKind};
use crate::format::{ArcFeed, FeedCoding, Format, Itemized, SpindleCoding, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("annex-d-boring.tape");
    Preset {
        id: "annex-d-boring",
        title: "Annex D, boring machine",
        about: "The boring machine that ISO 2539 annex D takes as its example: X, Y and Z in two decimal places, table \
                positions by B, the spindle speed as an arithmetic code. F is the reciprocal of time, so that each cut \
                has its own; the last one is an arc through three points, in two blocks.",
        kind: PresetKind::Tape,
        format: Format {
            standard: Standard::Iso2539,
            classification: Some("CSM 433".to_owned()),
            detail: "N3.G2.X+42.Y+32.Z+32.B1.F4.S3.T2.M2*".to_owned(),
            itemized: Itemized {
                feed: Some(FeedCoding::TimeReciprocal),
                arc_feed: Some(ArcFeed::Time),
                spindle: Some(SpindleCoding::Arithmetic),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("F0002").unwrap_or(0),
    }
}
