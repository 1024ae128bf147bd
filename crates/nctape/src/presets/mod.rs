//! Tapes and CLDATA to begin with, each under its format: one file for each, its text beside it.

mod annex_d_boring;
mod annex_e_circular;
mod annex_e_parabolic;
mod cldata_annex_e;
mod cldata_drilling;
mod cldata_tilted_axis;
mod cldata_two_customs;
mod cutter_left;
mod eia_contour;
mod iso_1058_boring;
mod rotary_table;
mod tab_columns;
mod thread;
mod y_1702_block;
mod y_1702_holes;
mod y_1702_holes_incremental;
mod y_1702_holes_printed;

use crate::format::Format;

/// What the text of a preset is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PresetKind {
    /// A tape, read against its format.
    Tape,
    /// CLDATA, posted to its format.
    Cldata,
}

impl PresetKind {
    /// Its name in the interface.
    pub fn name(self) -> &'static str {
        match self {
            PresetKind::Tape => "tape",
            PresetKind::Cldata => "cldata",
        }
    }
}

/// A text with its format and what it teaches.
#[derive(Clone, Debug)]
pub struct Preset {
    /// A name that never changes.
    pub id: &'static str,
    /// What it is called.
    pub title: &'static str,
    /// What it teaches, in two sentences.
    pub about: &'static str,
    /// What its text is.
    pub kind: PresetKind,
    /// The format that it is read against, or posted to.
    pub format: Format,
    /// The text.
    pub source: &'static str,
    /// The byte of the text where the cursor stands when it opens.
    pub cursor: usize,
}

/// The presets whose text is a tape.
pub fn tapes() -> Vec<Preset> {
    all().into_iter().filter(|preset| preset.kind == PresetKind::Tape).collect()
}

/// All presets; the first is shown on a first visit.
pub fn all() -> Vec<Preset> {
    vec![
        annex_e_circular::preset(),
        annex_e_parabolic::preset(),
        annex_d_boring::preset(),
        iso_1058_boring::preset(),
        tab_columns::preset(),
        y_1702_block::preset(),
        y_1702_holes::preset(),
        y_1702_holes_incremental::preset(),
        y_1702_holes_printed::preset(),
        eia_contour::preset(),
        rotary_table::preset(),
        cutter_left::preset(),
        thread::preset(),
        cldata_annex_e::preset(),
        cldata_two_customs::preset(),
        cldata_drilling::preset(),
        cldata_tilted_axis::preset(),
    ]
}
