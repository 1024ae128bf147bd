//! A boring machine with the format of ISO 1058 annex D.

use super::{Preset, PresetKind};
use crate::format::{FeedCoding, Format, Itemized, SpindleCoding, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("iso-1058-boring.tape");
    Preset {
        id: "iso-1058-boring",
        title: "ISO 1058, boring machine",
        about: "A tape for the boring machine that ISO 1058 annex D takes as its example: positioning and \
                cuts parallel to the axes, the table turned by degrees. F and S are codes of the geometric \
                progression, each a number of a printed table, and a block may have two miscellaneous \
                functions.",
        kind: PresetKind::Tape,
        format: Format {
            standard: Standard::Iso1058,
            classification: Some("LSMD442".to_owned()),
            detail: "N3.G2.X+42.Y+32.Z31.B33.F2.S2.T2.M2*".to_owned(),
            itemized: Itemized {
                feed: Some(FeedCoding::Geometric),
                spindle: Some(SpindleCoding::Geometric),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("F34").unwrap_or(0),
    }
}
