//! The contour of ISO 2539 annex E, as the part-programming system would have handed it over.

use super::{Preset, PresetKind, annex_e_circular};

pub(super) fn preset() -> Preset {
    let source = include_str!("cldata-annex-e.cld");
    Preset {
        id: "cldata-annex-e",
        title: "CLDATA: the contour of annex E",
        about: "The contour of ISO 2539 annex E as CLDATA, posted to the format of its circular tape: F is the reciprocal \
                of time, rounded down, and I and J are start minus centre, as printed.",
        kind: PresetKind::Cldata,
        format: annex_e_circular::preset().format,
        source,
        cursor: source.find("9,3000").unwrap_or(0),
    }
}
