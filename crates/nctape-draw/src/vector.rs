//! Tape as a drawing in millimetres, for a printer, a plotter or a laser.

use crate::dimensions::{CODE_HOLE, FEED_HOLE, FEED_LINE, ROW_PITCH, TRACKS, WIDTH, track_centre_mm};
use std::fmt::Write;

/// Millimetres between the lines of tape: room for scissors.
const GAP: f64 = 5.0;

/// Draws rows as SVG in true millimetres, `in_line` of them (at least one) to a line of tape.
///
/// A line of tape is a rectangle, and every hole a circle upon it, at its nominal place and with its nominal diameter
/// ([`crate::dimensions`]). Rows run from left to right, the reference edge is the lower one. The last line is bare tape to
/// its end where there are several.
///
/// ```
/// let drawing = nctape_draw::svg(&[0x4e], 100);
///
/// assert!(drawing.starts_with("<svg"));
/// // Four code holes and the feed hole.
/// assert_eq!(drawing.matches("<circle").count(), 5);
/// ```
pub fn svg(rows: &[u8], in_line: usize) -> String {
    let in_line = in_line.max(1);
    let lines: Vec<&[u8]> = if rows.is_empty() { vec![&[]] } else { rows.chunks(in_line).collect() };
    let rows_wide = if lines.len() > 1 { in_line } else { rows.len().max(1) };
    let width = rows_wide as f64 * ROW_PITCH.nominal;
    let height = lines.len() as f64 * (WIDTH.nominal + GAP) - GAP;
    let mut drawing = String::with_capacity(160 * rows.len() + 600);
    // Writing to a string cannot fail.
    let _ = write!(
        drawing,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width:.2}mm" height="{height:.2}mm" viewBox="0 0 {width:.2} {height:.2}">"#
    );
    for (index, line) in lines.iter().enumerate() {
        let top = index as f64 * (WIDTH.nominal + GAP);
        let reference_edge = top + WIDTH.nominal;
        let _ = write!(
            drawing,
            "\n<rect y=\"{top:.2}\" width=\"{width:.2}\" height=\"{:.2}\" fill=\"#f0e2bd\"/>\n<g fill=\"#fff\" stroke=\"#3b4650\" stroke-width=\".05\">",
            WIDTH.nominal
        );
        for place in 0..rows_wide {
            let byte = line.get(place).copied().unwrap_or(0);
            let x = (place as f64 + 0.5) * ROW_PITCH.nominal;
            let mut hole = |from_edge: f64, diameter: f64| {
                let (y, radius) = (reference_edge - from_edge, diameter / 2.0);
                let _ = write!(drawing, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.3}\"/>");
            };
            hole(FEED_LINE.nominal, FEED_HOLE.nominal);
            for track in (1..=TRACKS).filter(|track| byte >> (track - 1) & 1 == 1) {
                // Every track from 1 to 8 has a place.
                hole(track_centre_mm(track).unwrap_or(FEED_LINE.nominal), CODE_HOLE.nominal);
            }
        }
        drawing.push_str("</g>");
    }
    drawing.push_str("\n</svg>\n");
    drawing
}
