//! The hole pattern of Y-1702, figure 3, in incremental data with the signs as printed.

use super::y_1702_holes::holes;
use super::{Preset, PresetKind};
use crate::format::Dimensions;

pub(super) fn preset() -> Preset {
    let source = include_str!("y-1702-holes-printed.tape");
    Preset {
        id: "y-1702-holes-printed",
        title: "Y-1702, holes with the printed signs",
        about: "The incremental list with the signs that the report prints: x-2000 in n009 should be x+2000, \
                and x-0000 in n008 is a minus zero. Nothing in the tape itself shows the slip, yet the tool \
                ends 4 inches to the left of A.",
        kind: PresetKind::Tape,
        format: holes(Dimensions::Incremental),
        source,
        cursor: source.find("x-2000 y+3000").unwrap_or(0),
    }
}
