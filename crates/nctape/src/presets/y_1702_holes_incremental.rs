//! The hole pattern of Y-1702, figure 3, in incremental data.

use super::Preset;
use crate::format::{Dimensions, Format, Itemized, Standard, TapeCode};

pub(super) fn preset() -> Preset {
    let source = include_str!("y-1702-holes-incremental.tape");
    Preset {
        id: "y-1702-holes-incremental",
        title: "Y-1702, holes in incremental data",
        about: "The same hole pattern in incremental data: each word is the way from the hole before. The \
                last block has x+2000, so that all departures of an axis add up to nothing and the tool is \
                back at A; the report prints another sign there.",
        format: Format {
            standard: Standard::Rs274,
            classification: None,
            detail: "n3 g2 x+13 y+13 m2*".to_owned(),
            itemized: Itemized {
                code: Some(TapeCode::Eia),
                dimensions: Some(Dimensions::Incremental),
                ..Itemized::default()
            },
        },
        source,
        cursor: source.find("x+2000").unwrap_or(0),
    }
}
