//! What becomes of the functions of ISO 1056 in LinuxCNC, where many numbers mean something else.

/// What becomes of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fate {
    /// Its effect is in what is written anyhow: absolute coordinates, planes, feeds.
    Absorbed,
    /// Words of a group of LinuxCNC's, before the motion of the block.
    Before(u32, &'static str),
    /// Words of a group of LinuxCNC's, behind the motion of the block.
    After(u32, &'static str),
    /// The same, but without all that the function does.
    Partly(u32, &'static str),
    /// An end of program.
    End(&'static str),
    /// Nothing of LinuxCNC's does the same, or its effect is not worked out.
    LeftOut,
}

/// LinuxCNC's groups of miscellaneous functions, of which a line may have one each.
const STOP: u32 = 4;
pub(super) const TOOL: u32 = 6;
pub(super) const SPINDLE: u32 = 7;
const COOLANT: u32 = 8;
const OVERRIDE: u32 = 9;
/// S, which comes with no group of LinuxCNC's.
pub(super) const SPEED: u32 = 20;

/// A preparatory function. G00 to G06, G33 to G35 and dwell are written with their motions; the functions that cancel
/// what is never written have nothing to do.
pub(super) fn preparatory(code: u8) -> Fate {
    match code {
        0..=4 | 6 | 17..=19 | 33..=35 | 40 | 53 | 80 | 90..=97 => Fate::Absorbed,
        // G08 and G09 say how speed is gained and lost; LinuxCNC's G8 is radius mode. G43 to G59 are offsets and
        // shifts of other kinds here and there; so are G60 to G62, which say how exactly a position is met.
        _ => Fate::LeftOut,
    }
}

/// A miscellaneous function: when it acts is that of ISO 1056. M06, which leaves it open, comes before the motion, where
/// LinuxCNC itself carries it out.
pub(super) fn miscellaneous(code: u8) -> &'static [Fate] {
    use Fate::{After, Before, End, LeftOut, Partly};
    match code {
        // A program stop stops spindle and coolant too: so RS-274-D defines it, recalled. LinuxCNC's does not.
        0 => &[After(SPINDLE, "M5"), After(COOLANT, "M9"), After(STOP, "M0")],
        1 => &[After(STOP, "M1")],
        2 => &[End("M2")],
        3 => &[Before(SPINDLE, "M3")],
        4 => &[Before(SPINDLE, "M4")],
        5 => &[After(SPINDLE, "M5")],
        6 => &[Before(TOOL, "M6")],
        7 => &[Before(COOLANT, "M7")],
        8 => &[Before(COOLANT, "M8")],
        9 => &[After(COOLANT, "M9")],
        13 => &[Before(SPINDLE, "M3"), Before(COOLANT, "M8")],
        14 => &[Before(SPINDLE, "M4"), Before(COOLANT, "M8")],
        // The angle at which the spindle stops is the machine's.
        19 => &[Partly(SPINDLE, "M5")],
        30 => &[End("M30")],
        // Bypass of the feed override: LinuxCNC's M48 and M49 concern the spindle too.
        48 => &[After(OVERRIDE, "M50 P1")],
        49 => &[Before(OVERRIDE, "M50 P0")],
        60 => &[After(STOP, "M60")],
        _ => &[LeftOut],
    }
}
