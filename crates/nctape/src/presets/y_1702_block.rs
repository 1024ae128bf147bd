//! The block of Y-1702, page 11.

use super::{Preset, PresetKind};
use crate::format::{Dimensions, FeedCoding, Format, Itemized, Standard, TapeCode};

pub(super) fn preset() -> Preset {
    let source = include_str!("y-1702-block.tape");
    Preset {
        id: "y-1702-block",
        title: "Y-1702, one block in EIA code",
        about: "The block that the Y-12 report of 1969 explains word by word, in EIA RS-244: departures in inches, with \
                no decimal point on the tape. Its block 25 is the report's; the second block only ends the program.",
        kind: PresetKind::Tape,
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
