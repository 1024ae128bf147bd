//! From millimetres on the tape to pixels in the picture.
//!
//! Rows run along x; y counts downwards from the bench above the far edge to the bench below the reference edge.

use crate::dimensions::{ROW_PITCH, TRACK_PITCH, TRACKS, WIDTH, track_centre_mm};

/// The measures of one column of pixels by a row's pitch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    pub(crate) pitch: u32,
}

impl Layout {
    /// Pixels that so many millimetres take.
    pub(crate) fn pixels(self, millimetres: f64) -> f64 {
        millimetres * f64::from(self.pitch) / ROW_PITCH.nominal
    }

    /// Millimetres that so many pixels take.
    pub(crate) fn millimetres(self, pixels: f64) -> f64 {
        pixels * ROW_PITCH.nominal / f64::from(self.pitch)
    }

    /// Bench above the paper, and as much below it: one pitch, which the shadow needs to fade out.
    pub(crate) fn paper_top(self) -> u32 {
        self.pitch
    }

    /// The tape is as wide as ten rows are long, so this is whole at any pitch.
    pub(crate) fn paper_height(self) -> u32 {
        self.pixels(WIDTH.nominal).round() as u32
    }

    pub(crate) fn height(self) -> u32 {
        self.paper_top() + self.paper_height() + self.paper_top()
    }

    /// How far down the picture a distance from the reference edge is.
    pub(crate) fn y(self, from_reference_edge: f64) -> f64 {
        f64::from(self.paper_top() + self.paper_height()) - self.pixels(from_reference_edge)
    }

    /// The bit of the track to which a line of pixels belongs: the one less than half a track pitch away.
    /// None is set on the bench, at the edges and in the line of the feed holes.
    pub(crate) fn track_bit(self, line: u32) -> u8 {
        let middle = f64::from(line) + 0.5;
        let reach = self.pixels(TRACK_PITCH.nominal) / 2.0;
        (1..=TRACKS)
            .find(|track| track_centre_mm(*track).is_some_and(|centre| (self.y(centre) - middle).abs() < reach))
            .map_or(0, |track| 1 << (track - 1))
    }
}
