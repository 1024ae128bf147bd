//! The tape without its holes: bench, shadow and paper.
//!
//! All of it depends on the place across the tape alone, never on the place along it,
//! so that any two columns fit together without a seam.

use crate::dimensions::{ROW_PITCH, WIDTH};
use crate::layout::Layout;
use crate::theme::{Colours, Rgb, mix};

/// How far the shadow reaches, in millimetres. The light comes from above the picture:
/// the tape keeps more of it from the bench below its lower edge.
const SHADOW_REACH: f64 = ROW_PITCH.nominal;

/// How dark the shadow is right at the upper and at the lower edge, as a share of the full shadow.
const UPPER_SHADOW: f64 = 0.45;
const LOWER_SHADOW: f64 = 0.95;

/// What is seen of the paper's cut edges, in millimetres: about the thickness of the paper.
const CUT: f64 = 0.1;

/// How strongly the upper cut is lit, and the lower one is dark.
const CUT_LIGHT: f64 = 0.8;
const CUT_DARK: f64 = 0.35;

/// The colour of a line of pixels along the tape.
pub(crate) fn line_colour(layout: Layout, colours: &Colours, line: u32) -> Rgb {
    let from_reference_edge = layout.millimetres(layout.y(0.0) - (f64::from(line) + 0.5));
    let from_far_edge = WIDTH.nominal - from_reference_edge;
    if from_far_edge < 0.0 {
        return shadow(colours, -from_far_edge, UPPER_SHADOW);
    }
    if from_reference_edge < 0.0 {
        return shadow(colours, -from_reference_edge, LOWER_SHADOW);
    }

    let paper = body(colours, from_reference_edge);
    // A cut thinner than a pixel lights or darkens the pixel by its share of it.
    let share = layout.pixels(CUT).min(1.0);
    let cut = CUT.max(layout.millimetres(1.0));
    if from_far_edge < cut {
        mix(paper, colours.cut, CUT_LIGHT * share)
    } else if from_reference_edge < cut {
        mix(paper, colours.shadow, CUT_DARK * share)
    } else {
        paper
    }
}

/// The bench at a distance from the tape, falling off by the cube so that the last line of pixels is bench and nothing else.
fn shadow(colours: &Colours, distance: f64, strength: f64) -> Rgb {
    let nearness = 1.0 - (distance / SHADOW_REACH).min(1.0);
    mix(colours.bench, colours.shadow, strength * nearness * nearness * nearness)
}

/// Tape comes off a reel and keeps some of its curl: it is brightest above the middle and darkest at the reference edge.
fn body(colours: &Colours, from_reference_edge: f64) -> Rgb {
    const BRIGHTEST: f64 = 0.62;
    let across = from_reference_edge / WIDTH.nominal - BRIGHTEST;
    mix(colours.paper, colours.paper_shade, across * across / (BRIGHTEST * BRIGHTEST))
}
