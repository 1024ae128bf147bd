//! The hole pattern of Y-1702, figure 3, in incremental data.

use super::y_1702_holes::holes;
use super::{Preset, PresetKind};
use crate::format::Dimensions;

pub(super) fn preset() -> Preset {
    let source = include_str!("y-1702-holes-incremental.tape");
    Preset {
        id: "y-1702-holes-incremental",
        title: "Y-1702, holes in incremental data",
        about: "The same hole pattern in incremental data: each word is the way from the hole before. The \
                last block has x+2000, so that all departures of an axis add up to nothing and the tool is \
                back at A; the report prints another sign there.",
        kind: PresetKind::Tape,
        format: holes(Dimensions::Incremental),
        source,
        cursor: source.find("x+2000").unwrap_or(0),
    }
}
