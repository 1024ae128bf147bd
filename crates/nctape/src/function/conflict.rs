//! Where the sources of the tables differ: what a user may know a code by, and what is taken here.

/// What another source says of a preparatory function; `None` where all at hand agree.
pub fn preparatory_conflict(number: u8) -> Option<&'static str> {
    let note = match number {
        5 => "RS-274 controls sometimes hold under it, until the operator cancels it.",
        10..=12 => "RS-274 controls sometimes lock and unlock the machine with it.",
        13..=16 => "In RS-274-D it selects axes, and stays in force.",
        // JB 3208-83 prints no more than "not specified".
        25..=29 | 36..=39 => {
            "JB 3208-83 only calls it not specified; RS-274-D and the notes of GOST 20999-83 leave it to the builder for \
             ever, and so does this table."
        }
        43 => "In RS-274-D it is the cutter offset at an inside corner, and one copy of JB 3208-83 has left.",
        44 => "In RS-274-D it is the cutter offset at an outside corner, and one copy of JB 3208-83 has right.",
        45..=49 => "RS-274-D leaves it unassigned.",
        50 => "RS-274-D keeps it for adaptive control.",
        60..=63 => "RS-274-D leaves it unassigned.",
        68 | 69 => "Only JB 3208-83 has it; GOST 20999-83, ISO 6983 and RS-274-D leave it unassigned.",
        70 => "In RS-274-D and ISO 6983 it is inch programming.",
        71 => "In RS-274-D and ISO 6983 it is metric programming.",
        72 | 73 => "In RS-274-D it is an arc in space.",
        74 => "In RS-274-D it keeps arcs within one quadrant.",
        75 => "In RS-274-D it lets arcs go beyond their quadrant.",
        _ => return None,
    };
    Some(note)
}

/// What another source says of a miscellaneous function; `None` where all at hand agree.
pub fn miscellaneous_conflict(number: u8) -> Option<&'static str> {
    let note = match number {
        12 => "In RS-274-D it is a synchronization code.",
        32..=35 => "Later lists have constant cutting speed here.",
        40..=45 => "DIN 66025 has the automatic choice of gear (M40) and five gears (M41 to M45).",
        47 => "In RS-274-D it goes back to the start of the program.",
        48 | 60 | 62 | 71 | 72 => "The sources differ on how long it acts.",
        58 => "In RS-274-D it cancels M59.",
        59 => "In RS-274-D it leaves the speed as it is under constant cutting speed.",
        68 | 69 => "Later lists clamp and unclamp the workpiece here.",
        78 | 79 => "Later lists clamp and unclamp a slide here.",
        _ => return None,
    };
    Some(note)
}
