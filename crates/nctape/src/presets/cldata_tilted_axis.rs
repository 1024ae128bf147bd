//! A tilted tool axis, made for this project.

use super::cldata_two_customs::mill;
use super::{Preset, PresetKind};

pub(super) fn preset() -> Preset {
    let source = include_str!("cldata-tilted-axis.cld");
    Preset {
        id: "cldata-tilted-axis",
        title: "CLDATA: a tool axis that is tilted",
        about: "Points with a tool axis (MULTAX), the last two of them tilted. A tape of three axes cannot say that: the \
                points are left out, the tape stops there, and its first block says INCOMPLETE.",
        kind: PresetKind::Cldata,
        format: mill(),
        source,
        cursor: source.find("10,5000").unwrap_or(0),
    }
}
