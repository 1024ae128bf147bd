//! A tape without addresses.

use super::{Preset, PresetKind};
use crate::format::{FeedCoding, Format, Itemized, SpindleCoding, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("tab-columns.tape");
    Preset {
        id: "tab-columns",
        title: "Tabs instead of addresses",
        about: "A rectangle milled on a control that has tabs and no addresses: a number means what its \
                column means. A word that is left out keeps its tab where others follow, and the tabs behind \
                the last word are dropped.",
        kind: PresetKind::Tape,
        format: Format {
            standard: Standard::Iso2539,
            classification: Some("CTM 332".to_owned()),
            detail: "N3.G2.X+33.Y+33.Z+33.F4.S3.T2.M2*".to_owned(),
            itemized: Itemized {
                feed: Some(FeedCoding::Direct),
                spindle: Some(SpindleCoding::Arithmetic),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("-003000").unwrap_or(0),
    }
}
