//! A punched hole.

use tiny_skia::{
    FillRule, GradientStop, Paint, PathBuilder, PixmapMut, Point, RadialGradient, Shader, SpreadMode, Transform,
};

use crate::dimensions::{CODE_HOLE, Dimension, FEED_HOLE, FEED_LINE, TRACKS, track_centre_mm};
use crate::layout::Layout;
use crate::theme::{Colours, Rgb, mix};

/// How far the rim's shadow falls on the bench inside the hole, in millimetres to the right and downwards.
const SHADOW_OFFSET: f64 = 0.13;

/// The soft border of that shadow, in millimetres.
const SHADOW_BLUR: f64 = 0.30;

/// How dark the bench is right at that rim, as a share of the full shadow.
const SHADOW: f64 = 0.9;

/// How far the lit cut of the paper looks out from behind the hole, in millimetres to the right and downwards.
const CUT_OFFSET: f64 = 0.04;

/// Punches a row into a column of paper: its feed hole, and a code hole for each bit that is set.
pub(crate) fn punch(row: u8, layout: Layout, colours: &Colours, column: &mut PixmapMut<'_>) {
    hole(FEED_LINE.nominal, FEED_HOLE, layout, colours, column);
    for track in (1..=TRACKS).filter(|track| row >> (track - 1) & 1 == 1) {
        if let Some(centre) = track_centre_mm(track) {
            hole(centre, CODE_HOLE, layout, colours, column);
        }
    }
}

fn hole(from_reference_edge: f64, diameter: Dimension, layout: Layout, colours: &Colours, column: &mut PixmapMut<'_>) {
    let x = f64::from(layout.pitch) / 2.0;
    let y = layout.y(from_reference_edge);
    let radius = layout.pixels(diameter.nominal / 2.0);

    let cut = layout.pixels(CUT_OFFSET);
    disc(x + cut, y + cut, radius, solid(colours.cut), column);

    let offset = layout.pixels(SHADOW_OFFSET);
    let blur = layout.pixels(SHADOW_BLUR);
    let lit = Point::from_xy((x + offset) as f32, (y + offset) as f32);
    let dark = mix(colours.bench, colours.shadow, SHADOW);
    let bench = RadialGradient::new(
        lit,
        (radius - blur) as f32,
        lit,
        (radius + blur) as f32,
        vec![GradientStop::new(0.0, opaque(colours.bench)), GradientStop::new(1.0, opaque(dark))],
        SpreadMode::Pad,
        Transform::identity(),
    );
    disc(x, y, radius, bench.unwrap_or(solid(colours.bench)), column);
}

fn disc(x: f64, y: f64, radius: f64, shader: Shader<'_>, column: &mut PixmapMut<'_>) {
    let paint = Paint { shader, ..Paint::default() };
    if let Some(circle) = PathBuilder::from_circle(x as f32, y as f32, radius as f32) {
        column.fill_path(&circle, &paint, FillRule::Winding, Transform::identity(), None);
    }
}

fn solid(colour: Rgb) -> Shader<'static> {
    Shader::SolidColor(opaque(colour))
}

fn opaque([red, green, blue]: Rgb) -> tiny_skia::Color {
    tiny_skia::Color::from_rgba8(red, green, blue, 255)
}
