//! Four holes about a rotary table.

use super::{Preset, PresetKind};
use crate::format::value::Positive;
use crate::format::{FeedCoding, Format, Itemized, Standard};

pub(super) fn preset() -> Preset {
    let source = include_str!("rotary-table.tape");
    Preset {
        id: "rotary-table",
        title: "Four holes on a rotary table",
        about: "A rotary table turns a part by quarters of a turn while the tool bores four holes into its rim: B is in degrees, and its dimension words have three places. What it does stands in a plot of its own below the path.",
        kind: PresetKind::Tape,
        format: Format {
            standard: Standard::Iso2539,
            classification: Some("CAMD 443".to_owned()),
            detail: "N3G2X+42Y+42Z+42B+33F4S4T2M2*".to_owned(),
            itemized: Itemized { feed: Some(FeedCoding::Direct), rapid: Some(Positive(5000.0)), ..Itemized::default() },
        },
        source,
        cursor: source.find("B+090000").unwrap_or(0),
    }
}
