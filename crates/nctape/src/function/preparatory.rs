//! Preparatory functions: the table of ISO 1056.
//!
//! ISO 1056:1975 itself was not at hand. The table is that of JB 3208-83, its Chinese adoption, compared with the
//! notes of GOST 20999-83, with DIN 66025 and with a list of EIA RS-274-D. Where they differ the entry says so.
//! The letters of the groups a, c and d are printed in sources at hand; e to k are recalled.

use super::Hold;

/// What a two-digit preparatory function means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preparatory {
    /// Assigned: group and meaning.
    Assigned(Group, &'static str),
    /// Not assigned: it means something only where the itemized data declares it.
    Unassigned,
    /// Left to the builder for ever: likewise, but no later standard will take it.
    PermanentlyUnassigned,
}

/// Functions of one group replace one another; those of [`Group::Once`] act in their own block only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// a: how the tool moves.
    Motion,
    /// c: the plane of arcs.
    Plane,
    /// d: cutter compensation.
    Compensation,
    /// (d): tool offsets, cancelled by any function of d.
    Offset,
    /// e: fixed cycles.
    Cycle,
    /// f: linear shift.
    Shift,
    /// h: quality of positioning.
    Positioning,
    /// i: kind of spindle speed.
    Spindle,
    /// j: absolute or incremental dimensions.
    Dimensions,
    /// k: kind of feed.
    Feed,
    /// No group: acts in its block only.
    Once,
}

impl Group {
    /// The groups whose functions stay in force, in the order in which a reader asks for them.
    pub const MODAL: [Group; 10] = [
        Group::Motion,
        Group::Plane,
        Group::Dimensions,
        Group::Feed,
        Group::Spindle,
        Group::Compensation,
        Group::Offset,
        Group::Shift,
        Group::Positioning,
        Group::Cycle,
    ];

    /// How long its functions act.
    pub fn hold(self) -> Hold {
        if self == Group::Once { Hold::Block } else { Hold::Stays }
    }

    /// Its letter in the table; empty for functions of no group.
    pub fn letter(self) -> &'static str {
        match self {
            Group::Motion => "a",
            Group::Plane => "c",
            Group::Compensation => "d",
            Group::Offset => "(d)",
            Group::Cycle => "e",
            Group::Shift => "f",
            Group::Positioning => "h",
            Group::Spindle => "i",
            Group::Dimensions => "j",
            Group::Feed => "k",
            Group::Once => "",
        }
    }

    /// What it is about, in a word or two.
    pub fn title(self) -> &'static str {
        match self {
            Group::Motion => "Motion",
            Group::Plane => "Plane",
            Group::Compensation => "Cutter",
            Group::Offset => "Tool offset",
            Group::Cycle => "Cycle",
            Group::Shift => "Shift",
            Group::Positioning => "Positioning",
            Group::Spindle => "Speed kind",
            Group::Dimensions => "Dimensions",
            Group::Feed => "Feed kind",
            Group::Once => "This block",
        }
    }
}

/// The entry of G00 to G99; a number above 99 is unassigned.
pub fn preparatory(number: u8) -> Preparatory {
    use Group::*;
    let assigned = Preparatory::Assigned;
    match number {
        0 => assigned(Motion, "Point-to-point positioning"),
        1 => assigned(Motion, "Linear interpolation"),
        2 => assigned(Motion, "Circular interpolation, arc clockwise"),
        3 => assigned(Motion, "Circular interpolation, arc counter-clockwise"),
        4 => assigned(Once, "Dwell"),
        6 => assigned(Motion, "Parabolic interpolation"),
        8 => assigned(Once, "Acceleration"),
        9 => assigned(Once, "Deceleration"),
        17 => assigned(Plane, "Plane selection XY"),
        18 => assigned(Plane, "Plane selection ZX"),
        19 => assigned(Plane, "Plane selection YZ"),
        33 => assigned(Motion, "Thread cutting, constant lead"),
        34 => assigned(Motion, "Thread cutting, increasing lead"),
        35 => assigned(Motion, "Thread cutting, decreasing lead"),
        40 => assigned(Compensation, "Cutter compensation cancel"),
        41 => assigned(Compensation, "Cutter compensation, left"),
        42 => assigned(Compensation, "Cutter compensation, right"),
        // G43 to G52, G68 and G69 are free for other use on a control without such offsets; G43 and G44 are
        // offsets at inside and outside corners in RS-274-D.
        43 => assigned(Offset, "Tool offset, positive"),
        44 => assigned(Offset, "Tool offset, negative"),
        45 => assigned(Offset, "Tool offset +/+"),
        46 => assigned(Offset, "Tool offset +/-"),
        47 => assigned(Offset, "Tool offset -/-"),
        48 => assigned(Offset, "Tool offset -/+"),
        49 => assigned(Offset, "Tool offset 0/+"),
        50 => assigned(Offset, "Tool offset 0/-"),
        51 => assigned(Offset, "Tool offset +/0"),
        52 => assigned(Offset, "Tool offset -/0"),
        // G53 to G63 are free where a control has no shift or no such positioning (note of JB 3208-83).
        53 => assigned(Shift, "Linear shift cancel"),
        54 => assigned(Shift, "Linear shift X"),
        55 => assigned(Shift, "Linear shift Y"),
        56 => assigned(Shift, "Linear shift Z"),
        57 => assigned(Shift, "Linear shift XY"),
        58 => assigned(Shift, "Linear shift XZ"),
        59 => assigned(Shift, "Linear shift YZ"),
        60 => assigned(Positioning, "Precise positioning 1 (fine)"),
        61 => assigned(Positioning, "Precise positioning 2 (medium)"),
        62 => assigned(Positioning, "Quick positioning (coarse)"),
        63 => assigned(Once, "Tapping"),
        68 => assigned(Offset, "Tool offset, inside corner"),
        69 => assigned(Offset, "Tool offset, outside corner"),
        80 => assigned(Cycle, "Fixed cycle cancel"),
        81 => assigned(Cycle, "Fixed cycle 1: drill"),
        82 => assigned(Cycle, "Fixed cycle 2: drill with dwell"),
        83 => assigned(Cycle, "Fixed cycle 3: deep hole"),
        84 => assigned(Cycle, "Fixed cycle 4: tapping"),
        85 => assigned(Cycle, "Fixed cycle 5: boring"),
        86 => assigned(Cycle, "Fixed cycle 6: boring, spindle stop"),
        87 => assigned(Cycle, "Fixed cycle 7: boring, manual return"),
        88 => assigned(Cycle, "Fixed cycle 8: boring, dwell, manual return"),
        89 => assigned(Cycle, "Fixed cycle 9: boring, dwell"),
        90 => assigned(Dimensions, "Absolute dimensions"),
        91 => assigned(Dimensions, "Incremental dimensions"),
        92 => assigned(Once, "Preload of registers"),
        93 => assigned(Feed, "Feed as the reciprocal of time"),
        94 => assigned(Feed, "Feed per minute"),
        95 => assigned(Feed, "Feed per spindle revolution"),
        96 => assigned(Spindle, "Constant cutting speed"),
        97 => assigned(Spindle, "Spindle speed in revolutions per minute"),
        // JB 3208-83 only says "not specified"; RS-274-D and the notes of GOST 20999-83 agree on "permanently".
        25..=29 | 36..=39 => Preparatory::PermanentlyUnassigned,
        _ => Preparatory::Unassigned,
    }
}
