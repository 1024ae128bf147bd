//! A thread on a lathe.

use super::{Preset, PresetKind};
use crate::format::value::Positive;
use crate::format::{Format, Itemized, Plane, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("thread.tape");
    Preset {
        id: "thread",
        title: "A thread on a lathe",
        about: "A thread of 1,5 mm lead, cut in three passes on a lathe: under G33 the tool goes on by K with every revolution of the spindle, so that the speed in S gives the time and no feed is needed.",
        kind: PresetKind::Tape,
        format: Format {
            standard: Standard::Iso2539,
            classification: Some("CAM 222".to_owned()),
            detail: "N3G2X+42Z+42K+22S4T2M2*".to_owned(),
            itemized: Itemized { plane: Some(Plane::Zx), rapid: Some(Positive(5000.0)), ..Itemized::default() },
        },
        source,
        cursor: source.find("G33").unwrap_or(0),
    }
}
