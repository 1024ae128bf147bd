//! Tapes to begin with, each under its format: one file for each, its text beside it.

mod annex_d_boring;
mod annex_e_circular;
mod annex_e_parabolic;
mod eia_contour;
mod iso_1058_boring;
mod tab_columns;
mod y_1702_block;
mod y_1702_holes;
mod y_1702_holes_incremental;
mod y_1702_holes_printed;

use crate::format::Format;

/// A tape with its format and what it teaches.
#[derive(Clone, Debug)]
pub struct Preset {
    /// A name that never changes.
    pub id: &'static str,
    /// What it is called.
    pub title: &'static str,
    /// What it teaches, in two sentences.
    pub about: &'static str,
    /// The format that it is read against.
    pub format: Format,
    /// The text.
    pub source: &'static str,
    /// The byte of the text where the cursor stands when it opens.
    pub cursor: usize,
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
    ]
}
