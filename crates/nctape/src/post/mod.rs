//! The post-processor: CLDATA becomes a tape of a format.
//!
//! ```text
//! CLDATA ─► steps ── motion, command, cycle ─► tape writer ─► tape text
//!    │        └──────── diagnostics ────────┘                    │
//!    └──────────────────────── map ──────────────────────────────┘
//! ```
//!
//! What a text says is what [`crate::cldata`] makes of it; how a format says it is what the tape writer knows. In
//! between stands the order of things at the machine: what is modal, what comes before a motion, what a cycle is made
//! of. The files:
//!
//! | file | what |
//! |---|---|
//! | `source` | the reference language, or CL text turned into it; places in the text as given |
//! | `posting` | walks over the steps of every file and keeps the map |
//! | `motion` | straight motions, and what must be so before one |
//! | `curve` | arcs: as circles, as parabolas, as chords |
//! | `command` | the words of ISO 4343 that a tape knows |
//! | `machine` | spindle, coolant, tools, cutter compensation |
//! | `cycle` | holes in long hand |
//!
//! What cannot be said is left out, reported, and the tape stops there (M00): what lies behind a gap is not to be run
//! unseen. The first block of such a tape says INCOMPLETE in a comment (annex B.2), so that whoever holds the tape
//! knows it without the report.

mod command;
mod curve;
mod cycle;
mod machine;
mod motion;
mod posting;
mod source;

use crate::cldata::{self, Cldata};
use crate::convert::Converted;
use crate::format::{Control, Format, choices};
use posting::Poster;
use source::Source;

choices! {
    /// What arcs become. A format does not say which interpolations a control is fitted with.
    Arcs {
        /// Arcs, in the reading of I, J and K that the format declares.
        Circles = "circles", "circles (G02, G03)";
        /// Parabolas through three points, as in the parabolic tape of ISO 2539 annex E.
        Parabolas = "parabolas", "parabolas (G06)";
        /// Straight cuts.
        Chords = "chords", "straight cuts (G01)";
    }
}

/// How CLDATA is read and posted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// How the text is read; columns are those of the reference language.
    pub reading: cldata::Options,
    /// What arcs become; circles while it is not stated.
    pub arcs: Option<Arcs>,
    /// The control carries out no more than a quadrant of a circle at a time, as in the circular tape of ISO 2539
    /// annex E. Where I, J and K have no sign that holds anyhow.
    pub quadrants: bool,
    /// How far parabolas and chords may lie off an arc, in the unit of the format, the rounding to its least input
    /// increment not counted. While it is not stated it is what the text states (INTOL, OUTTOL), otherwise half an
    /// increment, as far off as the tape may be anyhow. Of a number that is not positive, the same.
    pub tolerance: Option<f64>,
}

/// The tape of a format that does what CLDATA says: the reference language of ISO 3592, or CL text of today's CAM
/// systems, which is turned into it first.
///
/// Any text gives a tape. Each file becomes a program. The places in the diagnostics and in the map are those of the
/// text as given. A tape is incomplete where a diagnostic is an error: [`Converted::is_incomplete`].
///
/// ```
/// use nctape::{Format, Standard};
/// let format = Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42F4M2*").classified("CAM 333");
/// let cldata = "1,9000,9,1;\n2,20000,0,RAPID;\n3,5000,5,'',0,10.5,-3.,.;\n4,20000,0,END;\n5,14000;\n:\n";
/// let tape = nctape::post::postprocess(cldata, &format);
/// assert_eq!(tape.text, "%\nN001 G00 X+001050 Y-000300\nN002 M02\n");
/// ```
pub fn postprocess(cldata: &str, to: &Format) -> Converted {
    postprocess_with(cldata, to, &Options::default())
}

/// The same, otherwise than by default.
pub fn postprocess_with(cldata: &str, to: &Format, options: &Options) -> Converted {
    post(&Source::read(cldata, &options.reading), to, options)
}

/// The same, with what is found in the text itself: the reference language is read once for both.
pub fn read_and_post(cldata: &str, to: &Format, options: &Options) -> (Cldata, Converted) {
    let source = Source::read(cldata, &options.reading);
    let posted = post(&source, to, options);
    (source.into_cldata().unwrap_or_else(|| Cldata::new(cldata, &options.reading)), posted)
}

fn post(source: &Source, to: &Format, options: &Options) -> Converted {
    let control = Control::new(to);
    let posted = Poster::new(source, &control, options, false).post();
    // That a tape is incomplete is known at its end and said at its start.
    if posted.is_incomplete() { Poster::new(source, &control, options, true).post() } else { posted }
}
