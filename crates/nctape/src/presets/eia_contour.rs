//! A contouring tape in EIA code.

use super::{Preset, PresetKind};
use crate::format::{ArcCentre, ArcFeed, Dimensions, FeedCoding, Format, Itemized, Standard, TapeCode, TimeScale};

pub(super) fn preset() -> Preset {
    let source = include_str!("eia-contour.tape");
    Preset {
        id: "eia-contour",
        title: "A disc in EIA code",
        about: "A disc of 3 inches, milled by a contouring control of the 1960s in EIA RS-244: its circular \
                interpolator works in one quadrant, so that the circle is four blocks and i and j have no \
                sign. f is ten times the reciprocal of time in minutes, 10 inches per minute throughout.",
        kind: PresetKind::Tape,
        format: Format {
            standard: Standard::Rs274,
            classification: None,
            detail: "n3 g2 x+14 y+14 z+14 i14 j14 f4 m2*".to_owned(),
            itemized: Itemized {
                code: Some(TapeCode::Eia),
                dimensions: Some(Dimensions::Incremental),
                arc_centre: Some(ArcCentre::Quadrant),
                feed: Some(FeedCoding::TimeReciprocal),
                arc_feed: Some(ArcFeed::Time),
                time_scale: Some(TimeScale(10)),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("g02").unwrap_or(0),
    }
}
