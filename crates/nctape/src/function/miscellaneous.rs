//! Miscellaneous functions: the table of ISO 1056.
//!
//! ISO 1056:1975 itself was not at hand; the table is that of JB 3208-83 in two transcriptions. A Heidenhain TNC 155
//! manual agrees on the start of effect of the ten functions that it lists.

/// What a two-digit miscellaneous function means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Miscellaneous {
    /// Assigned: when it acts, and its meaning.
    Assigned(Start, &'static str),
    /// Not assigned: it means something only where the itemized data declares it.
    Unassigned,
    /// Left to the builder for ever.
    PermanentlyUnassigned,
}

/// When a miscellaneous function acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// With the motion of its block.
    With,
    /// After the motion of its block.
    After,
    /// Left open by the standard: the itemized data says.
    Open,
}

/// The entry of M00 to M99; a number above 99 is unassigned.
pub fn miscellaneous(number: u8) -> Miscellaneous {
    use Start::*;
    let assigned = Miscellaneous::Assigned;
    match number {
        0 => assigned(After, "Program stop"),
        1 => assigned(After, "Optional (planned) stop"),
        2 => assigned(After, "End of program"),
        3 => assigned(With, "Spindle clockwise"),
        4 => assigned(With, "Spindle counter-clockwise"),
        5 => assigned(After, "Spindle off"),
        6 => assigned(Open, "Tool change"),
        7 => assigned(With, "Coolant no. 2 on"),
        8 => assigned(With, "Coolant no. 1 on"),
        9 => assigned(After, "Coolant off"),
        10 => assigned(Open, "Clamp"),
        11 => assigned(Open, "Unclamp"),
        13 => assigned(With, "Spindle clockwise and coolant on"),
        14 => assigned(With, "Spindle counter-clockwise and coolant on"),
        15 => assigned(With, "Motion +"),
        16 => assigned(With, "Motion -"),
        19 => assigned(After, "Oriented spindle stop"),
        30 => assigned(After, "End of tape (rewind)"),
        31 => assigned(Open, "Interlock bypass"),
        36 => assigned(With, "Feed range 1"),
        37 => assigned(With, "Feed range 2"),
        38 => assigned(With, "Spindle speed range 1"),
        39 => assigned(With, "Spindle speed range 2"),
        40 => assigned(Open, "Gear change if required, otherwise unassigned"),
        41 => assigned(Open, "Gear change if required, otherwise unassigned"),
        42 => assigned(Open, "Gear change if required, otherwise unassigned"),
        43 => assigned(Open, "Gear change if required, otherwise unassigned"),
        44 => assigned(Open, "Gear change if required, otherwise unassigned"),
        45 => assigned(Open, "Gear change if required, otherwise unassigned"),
        48 => assigned(After, "Cancel M49"),
        49 => assigned(With, "Bypass feed override"),
        50 => assigned(With, "Coolant no. 3 on"),
        51 => assigned(With, "Coolant no. 4 on"),
        55 => assigned(With, "Linear tool shift, position 1"),
        56 => assigned(With, "Linear tool shift, position 2"),
        60 => assigned(After, "Workpiece change"),
        61 => assigned(With, "Linear workpiece shift, position 1"),
        62 => assigned(With, "Linear workpiece shift, position 2"),
        71 => assigned(With, "Angular workpiece shift, position 1"),
        72 => assigned(With, "Angular workpiece shift, position 2"),
        20..=29 | 90..=99 => Miscellaneous::PermanentlyUnassigned,
        _ => Miscellaneous::Unassigned,
    }
}
