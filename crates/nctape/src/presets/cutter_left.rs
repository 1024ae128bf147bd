//! A contour under cutter compensation.

use super::{Preset, PresetKind};
use crate::format::value::Positive;
use crate::format::{FeedCoding, Format, Itemized, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("cutter-left.tape");
    Preset {
        id: "cutter-left",
        title: "A contour left of the cutter",
        about: "A plate with a round corner, milled on its outside with G41: the tape has the contour of the part, and the control keeps the cutter to the left of it. The format states a radius of 6 mm, so that the path of its centre is drawn too; T0101 is tool 01 with the compensation in store 01.",
        kind: PresetKind::Tape,
        format: Format {
            standard: Standard::Iso2539,
            classification: Some("CAM 332".to_owned()),
            detail: "N3G2X+33Y+33Z+33I+33J+33F4S4T4M2*".to_owned(),
            itemized: Itemized {
                cutter_radius: Some(Positive(6.0)),
                compensation_digits: Some(2),
                feed: Some(FeedCoding::Direct),
                rapid: Some(Positive(5000.0)),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("G41").unwrap_or(0),
    }
}
