//! All 256 rows that can be punched, ready to be copied.
//!
//! Drawing a circle costs far more than copying it.
//! Two holes never touch, so a column can be put together from the lines of two that are drawn:
//! one without code holes and one with all eight. The test `made_up_columns_are_those_drawn_singly` holds it to that.
//! They take a 128th of what 256 columns would, which on a screen of high density is tens of megabytes,
//! and a change of pitch is done before the next frame.

use std::ops::RangeInclusive;

use tiny_skia::PixmapMut;

use crate::dimensions::{FEED_LINE, track_centre_mm};
use crate::hole::punch;
use crate::layout::Layout;
use crate::paper::line_colour;
use crate::picture::{BYTES_PER_PIXEL, Picture};
use crate::theme::Theme;
use crate::tile::tile;

const BLANK: u8 = 0x00;
const ALL_HOLES: u8 = 0xff;

/// The pictures of the 256 rows at one pitch and in one theme.
///
/// Make one for each pitch and theme on the screen, keep it, and give it to [`tile`].
#[derive(Clone, Debug)]
pub struct Columns {
    layout: Layout,
    theme: Theme,
    blank: Vec<u8>,
    all_holes: Vec<u8>,
    /// For each line of pixels, the bit of its track.
    track_bits: Vec<u8>,
}

impl Columns {
    /// The pitches that can be drawn, in pixels.
    ///
    /// At 4 the bridge of paper between two code holes is one pixel wide, and below that holes run together.
    /// At 64 the tape has its true size on a screen of 640 pixels to the inch, finer than any it will meet.
    pub const PITCHES: RangeInclusive<u32> = 4..=64;

    /// Draws the columns for so many device pixels from one row to the next.
    ///
    /// A pitch outside of [`Columns::PITCHES`] is replaced by the nearest inside; [`Columns::pitch`] tells which.
    pub fn new(pitch: u32, theme: Theme) -> Columns {
        let layout = Layout { pitch: pitch.clamp(*Columns::PITCHES.start(), *Columns::PITCHES.end()) };
        Columns {
            layout,
            theme,
            blank: draw(BLANK, layout, theme),
            all_holes: draw(ALL_HOLES, layout, theme),
            track_bits: (0..layout.height()).map(|line| layout.track_bit(line)).collect(),
        }
    }

    /// From one row to the next, in pixels: the width of a column.
    pub fn pitch(&self) -> u32 {
        self.layout.pitch
    }

    /// The theme in which the columns are drawn.
    pub fn theme(&self) -> Theme {
        self.theme
    }

    /// The height of a column, in pixels: the paper and the bench on both sides of it.
    pub fn height(&self) -> u32 {
        self.layout.height()
    }

    /// Where the paper begins, in pixels from the top. As much bench is below it.
    pub fn paper_top(&self) -> u32 {
        self.layout.paper_top()
    }

    /// The width of the tape, in pixels.
    pub fn paper_height(&self) -> u32 {
        self.layout.paper_height()
    }

    /// The centre line of a track, in pixels from the top; `None` where there is no such track.
    pub fn track_y(&self, track: u8) -> Option<f64> {
        track_centre_mm(track).map(|centre| self.layout.y(centre))
    }

    /// The line of the feed holes, in pixels from the top.
    pub fn feed_y(&self) -> f64 {
        self.layout.y(FEED_LINE.nominal)
    }

    /// All 256 columns in one picture, sixteen in a line: the upper four tracks choose the line, the lower four the place in it.
    pub fn sheet(&self) -> Picture {
        let mut sheet = Picture { width: 16 * self.pitch(), height: 16 * self.height(), rgba: Vec::new() };
        for upper in 0..16 {
            let rows: Vec<u8> = (0..16).map(|lower| upper << 4 | lower).collect();
            sheet.rgba.append(&mut tile(&rows, self).rgba);
        }
        sheet
    }

    /// Where a row's column is in the [sheet](Columns::sheet): its upper left corner, as `(x, y)` in pixels.
    pub fn position(&self, row: u8) -> (u32, u32) {
        (u32::from(row & 0x0f) * self.pitch(), u32::from(row >> 4) * self.height())
    }

    /// The lines of pixels from top to bottom, each with what a column may have in it.
    pub(crate) fn lines(&self) -> impl Iterator<Item = Line<'_>> {
        let length = self.layout.pitch as usize * BYTES_PER_PIXEL;
        self.track_bits
            .iter()
            .zip(self.blank.chunks_exact(length))
            .zip(self.all_holes.chunks_exact(length))
            .map(|((track_bit, blank), all_holes)| Line { track_bit: *track_bit, blank, all_holes })
    }
}

/// One line of pixels through a column.
pub(crate) struct Line<'a> {
    track_bit: u8,
    blank: &'a [u8],
    all_holes: &'a [u8],
}

impl<'a> Line<'a> {
    /// The pixels of a row's column in this line.
    pub(crate) fn pixels(&self, row: u8) -> &'a [u8] {
        if row & self.track_bit == 0 { self.blank } else { self.all_holes }
    }
}

/// The pixels of one column.
fn draw(row: u8, layout: Layout, theme: Theme) -> Vec<u8> {
    let colours = theme.colours();
    let mut rgba = Vec::new();
    for line in 0..layout.height() {
        let [red, green, blue] = line_colour(layout, &colours, line);
        rgba.extend([red, green, blue, 255].repeat(layout.pitch as usize));
    }
    let mut column = PixmapMut::from_bytes(&mut rgba, layout.pitch, layout.height())
        .expect("the bytes were counted out for this width and height");
    punch(row, layout, &colours, &mut column);
    rgba
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn made_up_columns_are_those_drawn_singly() {
        for pitch in Columns::PITCHES {
            let columns = Columns::new(pitch, Theme::Light);
            // Each track alone, and each alone not punched: a hole that reached into another track's lines would show.
            for row in (0..8).flat_map(|bit| [1 << bit, !(1 << bit)]) {
                let drawn = draw(row, columns.layout, Theme::Light);
                assert!(tile(&[row], &columns).rgba == drawn, "row {row:#04x} at pitch {pitch}");
            }
        }
    }

    #[test]
    fn a_pitch_out_of_range_is_replaced_by_the_nearest() {
        assert_eq!(Columns::new(0, Theme::Dark).pitch(), 4);
        assert_eq!(Columns::new(9999, Theme::Dark).pitch(), 64);
    }

    #[test]
    fn the_sheet_has_every_column_in_its_position() {
        let columns = Columns::new(5, Theme::Dark);
        let sheet = columns.sheet();
        let pixels = (sheet.width * sheet.height) as usize;
        assert_eq!(sheet.rgba.len(), pixels * BYTES_PER_PIXEL);
        for row in 0..=255 {
            let (left, top) = columns.position(row);
            for (y, line) in (top..).zip(columns.lines()) {
                let start = (y * sheet.width + left) as usize * BYTES_PER_PIXEL;
                let expected = line.pixels(row);
                let found = &sheet.rgba[start..start + expected.len()];
                assert_eq!(found, expected, "row {row:#04x}");
            }
        }
    }
}
