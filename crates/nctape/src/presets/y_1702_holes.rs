//! The hole pattern of Y-1702, figure 3, in absolute data.

use super::{Preset, PresetKind};
use crate::format::{Dimensions, Format, Itemized, Standard, TapeCode};

pub(super) fn preset() -> Preset {
    let source = include_str!("y-1702-holes.tape");
    Preset {
        id: "y-1702-holes",
        title: "Y-1702, holes in absolute data",
        about: "The hole pattern of Y-1702 in absolute data: eight holes from B to I, then back to A, each \
                measured from the origin at A. Block n001 goes to B, n002 to C, and so on; the +13 format \
                has one digit before the decimal sign and three behind it, in inches.",
        kind: PresetKind::Tape,
        format: holes(Dimensions::Absolute),
        source,
        cursor: source.find("x+2000").unwrap_or(0),
    }
}

/// The +13 format of the report's hole lists.
pub(super) fn holes(dimensions: Dimensions) -> Format {
    Format {
        standard: Standard::Rs274,
        classification: None,
        detail: "n3 g2 x+13 y+13 m2*".to_owned(),
        itemized: Itemized { code: Some(TapeCode::Eia), dimensions: Some(dimensions), ..Itemized::default() },
    }
}
