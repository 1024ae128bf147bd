//! Arcs in the two customs of CLDATA, made for this project.

use super::{Preset, PresetKind};
use crate::format::{Format, Itemized, SetPoint, Standard};
use std::collections::BTreeMap;

/// A milling machine that is wide enough for what is milled here.
pub(super) fn mill() -> Format {
    let rest = BTreeMap::from([("Z".to_owned(), 50.0)]);
    Format {
        standard: Standard::Iso2539,
        classification: Some("CAM 333".to_owned()),
        detail: "N4G2X+43Y+43Z+43I+43J+43K+43F4S4T2M2*".to_owned(),
        itemized: Itemized { set_point: Some(SetPoint::Named(rest)), ..Itemized::default() },
    }
}

pub(super) fn preset() -> Preset {
    let source = include_str!("cldata-two-customs.cld");
    Preset {
        id: "cldata-two-customs",
        title: "CLDATA: arcs in two customs",
        about: "Two quarters about the same centre. The first is written as systems of today do, with the circle of the \
                path and its end; the second as APT does, with the circle of the part, half a cutter inside, and points.",
        kind: PresetKind::Cldata,
        format: mill(),
        source,
        cursor: source.find("16,3000").unwrap_or(0),
    }
}
