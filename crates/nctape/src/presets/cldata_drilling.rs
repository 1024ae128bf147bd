//! Drilling as a CAM system of today hands it over, turned into the reference language. The CL text is from the repository
//! MichaHofft/CreoPost, copyright 2023 MichaHofft, under the MIT licence, which stands beside it.

use super::{Preset, PresetKind};
use crate::format::{Format, Itemized, SetPoint, Standard};
use std::collections::BTreeMap;

pub(super) fn preset() -> Preset {
    let source = include_str!("../../../../tests/cldata/creopost/bohren_1.cld");
    let start = BTreeMap::from([("Z".to_owned(), 50.0)]);
    Preset {
        id: "cldata-drilling",
        title: "CLDATA: deep holes from a CAM system",
        about: "Two deep holes as a CAM system wrote them, from CreoPost, copyright 2023 MichaHofft, MIT licence. The \
                cycle becomes its strokes in long hand, as every control carries them out.",
        kind: PresetKind::Cldata,
        format: Format {
            standard: Standard::Rs274,
            classification: None,
            detail: "n3 g2 x+24 y+24 z+24 f31 s4 t2 m2*".to_owned(),
            itemized: Itemized { set_point: Some(SetPoint::Named(start)), ..Itemized::default() },
        },
        source,
        cursor: source.find("18,20000").unwrap_or(0),
    }
}
