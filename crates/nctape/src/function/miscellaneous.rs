//! Miscellaneous functions: the table of ISO 1056.
//!
//! ISO 1056:1975 itself was not at hand; the table is that of JB 3208-83 in two transcriptions, whose scope marks and
//! a recalled copy of the standard's agree but where [`super::miscellaneous_conflict`] says otherwise. A Heidenhain
//! TNC 155 manual agrees on the start of effect of the ten functions that it lists. The names of the matters are ours:
//! the table tells them by its layout.

/// What a two-digit miscellaneous function means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Miscellaneous {
    /// Assigned: what it is about, when it begins to act, how long it does, and its meaning.
    Assigned(Matter, Start, Hold, &'static str),
    /// Not assigned: it means something only where the itemized data declares it.
    Unassigned,
    /// Left to the builder for ever.
    PermanentlyUnassigned,
}

/// What a miscellaneous function is about: those that stay in force replace the one before them of the same matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matter {
    /// Stops and ends of the program.
    Stop,
    /// The spindle.
    Spindle,
    /// Coolant.
    Coolant,
    /// Change of tool.
    Tool,
    /// Clamping of slides, workpiece, fixture or spindle.
    Clamp,
    /// Direction of a motion.
    Motion,
    /// Interlocks.
    Interlock,
    /// Range of feeds.
    FeedRange,
    /// Range of spindle speeds.
    SpeedRange,
    /// Gears.
    Gear,
    /// Override of the feed by the operator.
    Override,
    /// Shift of the tool.
    ToolShift,
    /// Change of workpiece.
    Workpiece,
    /// Shift of the workpiece.
    WorkpieceShift,
}

impl Matter {
    /// What it is about, in a word or two.
    pub fn title(self) -> &'static str {
        match self {
            Matter::Stop => "Program",
            Matter::Spindle => "Spindle",
            Matter::Coolant => "Coolant",
            Matter::Tool => "Tool",
            Matter::Clamp => "Clamps",
            Matter::Motion => "Motion",
            Matter::Interlock => "Interlock",
            Matter::FeedRange => "Feed range",
            Matter::SpeedRange => "Speed range",
            Matter::Gear => "Gear",
            Matter::Override => "Feed override",
            Matter::ToolShift => "Tool shift",
            Matter::Workpiece => "Workpiece",
            Matter::WorkpieceShift => "Workpiece shift",
        }
    }
}

/// When a miscellaneous function begins to act.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// With the motion of its block.
    With,
    /// After the motion of its block.
    After,
    /// Left open by the standard: the itemized data says.
    Open,
}

impl Start {
    /// It in words, behind "begins".
    pub fn words(self) -> &'static str {
        match self {
            Start::With => "with the motion of the block",
            Start::After => "after the motion of the block",
            Start::Open => "when the itemized data says",
        }
    }
}

/// How long a function acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Until another one of its group replaces it.
    Stays,
    /// In its block only.
    Block,
    /// Left open by the standard: the itemized data says.
    Open,
}

impl Hold {
    /// It in words.
    pub fn words(self) -> &'static str {
        match self {
            Hold::Stays => "until another function of its group",
            Hold::Block => "in this block only",
            Hold::Open => "as long as the itemized data says",
        }
    }
}

/// The entry of M00 to M99; a number above 99 is unassigned.
pub fn miscellaneous(number: u8) -> Miscellaneous {
    use Hold::{Block, Stays};
    use Start::{After, With};
    let assigned = Miscellaneous::Assigned;
    match number {
        0 => assigned(Matter::Stop, After, Block, "Program stop"),
        1 => assigned(Matter::Stop, After, Block, "Optional (planned) stop"),
        2 => assigned(Matter::Stop, After, Block, "End of program"),
        3 => assigned(Matter::Spindle, With, Stays, "Spindle clockwise"),
        4 => assigned(Matter::Spindle, With, Stays, "Spindle counter-clockwise"),
        5 => assigned(Matter::Spindle, After, Stays, "Spindle off"),
        6 => assigned(Matter::Tool, Start::Open, Block, "Tool change"),
        7 => assigned(Matter::Coolant, With, Stays, "Coolant no. 2 on"),
        8 => assigned(Matter::Coolant, With, Stays, "Coolant no. 1 on"),
        9 => assigned(Matter::Coolant, After, Stays, "Coolant off"),
        10 => assigned(Matter::Clamp, Start::Open, Stays, "Clamp"),
        11 => assigned(Matter::Clamp, Start::Open, Stays, "Unclamp"),
        13 => assigned(Matter::Spindle, With, Stays, "Spindle clockwise and coolant on"),
        14 => assigned(Matter::Spindle, With, Stays, "Spindle counter-clockwise and coolant on"),
        15 => assigned(Matter::Motion, With, Block, "Motion +"),
        16 => assigned(Matter::Motion, With, Block, "Motion -"),
        19 => assigned(Matter::Spindle, After, Stays, "Oriented spindle stop"),
        30 => assigned(Matter::Stop, After, Block, "End of tape (rewind)"),
        31 => assigned(Matter::Interlock, Start::Open, Block, "Interlock bypass"),
        36 => assigned(Matter::FeedRange, With, Hold::Open, "Feed range 1"),
        37 => assigned(Matter::FeedRange, With, Hold::Open, "Feed range 2"),
        38 => assigned(Matter::SpeedRange, With, Hold::Open, "Spindle speed range 1"),
        39 => assigned(Matter::SpeedRange, With, Hold::Open, "Spindle speed range 2"),
        40..=45 => assigned(Matter::Gear, Start::Open, Hold::Open, "Gear change if required, otherwise unassigned"),
        // Retention of M48, M60, M62, M71 and M72: recalled; see the conflicts.
        48 => assigned(Matter::Override, After, Stays, "Cancel M49"),
        49 => assigned(Matter::Override, With, Hold::Open, "Bypass feed override"),
        50 => assigned(Matter::Coolant, With, Hold::Open, "Coolant no. 3 on"),
        51 => assigned(Matter::Coolant, With, Hold::Open, "Coolant no. 4 on"),
        55 => assigned(Matter::ToolShift, With, Hold::Open, "Linear tool shift, position 1"),
        56 => assigned(Matter::ToolShift, With, Hold::Open, "Linear tool shift, position 2"),
        60 => assigned(Matter::Workpiece, After, Block, "Workpiece change"),
        61 => assigned(Matter::WorkpieceShift, With, Stays, "Linear workpiece shift, position 1"),
        62 => assigned(Matter::WorkpieceShift, With, Stays, "Linear workpiece shift, position 2"),
        71 => assigned(Matter::WorkpieceShift, With, Stays, "Angular workpiece shift, position 1"),
        72 => assigned(Matter::WorkpieceShift, With, Stays, "Angular workpiece shift, position 2"),
        20..=29 | 90..=99 => Miscellaneous::PermanentlyUnassigned,
        _ => Miscellaneous::Unassigned,
    }
}
