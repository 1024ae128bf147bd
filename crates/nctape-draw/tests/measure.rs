//! Measures drawn tape like real tape, with a rule laid on its picture, against the numbers of the standard.
//!
//! The numbers stand here once more, as the punch's manual lists them, and not as the crate computes them.

use std::f64::consts::PI;
use std::ops::Range;

use nctape_draw::{Columns, Picture, Theme, tile};

/// Centres in millimetres from the reference edge: tracks 1 to 8.
const TRACKS: [f64; 8] = [2.34, 4.88, 7.42, 12.50, 15.04, 17.58, 20.12, 22.66];
const FEED: f64 = 9.96;
const WIDTH: f64 = 25.40;
const CODE_DIAMETER: f64 = 1.83;
const FEED_DIAMETER: f64 = 1.17;

const PITCH: u32 = 40;
/// A row is 2.54 mm long.
const PIXELS_PER_MM: f64 = PITCH as f64 / 2.54;

const THEMES: [Theme; 2] = [Theme::Light, Theme::Dark];

/// What is seen of a hole: lengths in millimetres, `x` from the row's left border.
struct Hole {
    x: f64,
    from_reference_edge: f64,
    area: f64,
}

/// How much of each pixel is hole, from 0 (paper) to 1 (bench).
fn openness(picture: &Picture, theme: Theme, x: u32, y: u32) -> f64 {
    let colours = theme.colours();
    let bench = f64::from(colours.bench[0]);
    // The paper is measured beside the holes, in the first pixel of the line: no hole reaches a row's border.
    let paper = f64::from(red(picture, 0, y));
    ((paper - f64::from(red(picture, x, y))) / (paper - bench)).clamp(0.0, 1.0)
}

fn red(picture: &Picture, x: u32, y: u32) -> u8 {
    picture.rgba[4 * (y * picture.width + x) as usize]
}

/// The lines of the picture within half a pitch of a distance from the reference edge.
fn lines_around(columns: &Columns, from_reference_edge: f64) -> Range<u32> {
    let reference_edge = columns.paper_top() + columns.paper_height();
    let line = |distance: f64| reference_edge - (distance * PIXELS_PER_MM).round() as u32;
    line(from_reference_edge + 1.27)..line(from_reference_edge - 1.27)
}

fn measure(picture: &Picture, columns: &Columns, theme: Theme, from_reference_edge: f64) -> Hole {
    let (mut area, mut x_moment, mut y_moment) = (0.0, 0.0, 0.0);
    for y in lines_around(columns, from_reference_edge) {
        for x in 0..picture.width {
            let open = openness(picture, theme, x, y);
            area += open;
            x_moment += open * (f64::from(x) + 0.5);
            y_moment += open * (f64::from(y) + 0.5);
        }
    }
    let reference_edge = f64::from(columns.paper_top() + columns.paper_height());
    Hole {
        x: x_moment / area / PIXELS_PER_MM,
        from_reference_edge: (reference_edge - y_moment / area) / PIXELS_PER_MM,
        area: area / PIXELS_PER_MM / PIXELS_PER_MM,
    }
}

fn assert_hole(hole: &Hole, from_reference_edge: f64, diameter: f64) {
    assert!((hole.x - 1.27).abs() < 0.05, "x {}", hole.x);
    let measured = hole.from_reference_edge;
    assert!((measured - from_reference_edge).abs() < 0.05, "{measured} for {from_reference_edge}");
    let area = PI * diameter * diameter / 4.0;
    assert!((hole.area / area - 1.0).abs() < 0.03, "{} for {area}", hole.area);
}

#[test]
fn holes_are_where_the_standard_has_them_and_as_large() {
    for theme in THEMES {
        let columns = Columns::new(PITCH, theme);
        let picture = tile(&[0xff], &columns);
        for centre in TRACKS {
            let hole = measure(&picture, &columns, theme, centre);
            assert_hole(&hole, centre, CODE_DIAMETER);
        }
        let feed = measure(&picture, &columns, theme, FEED);
        assert_hole(&feed, FEED, FEED_DIAMETER);
    }
}

#[test]
fn every_row_has_its_feed_hole_and_the_code_holes_of_its_bits() {
    for theme in THEMES {
        let columns = Columns::new(PITCH, theme);
        for row in 0..=255_u8 {
            let picture = tile(&[row], &columns);
            assert_hole(&measure(&picture, &columns, theme, FEED), FEED, FEED_DIAMETER);
            for (bit, centre) in TRACKS.into_iter().enumerate() {
                let open = measure(&picture, &columns, theme, centre).area;
                let punched = row >> bit & 1 == 1;
                assert_eq!(1.0 < open, punched, "row {row:#04x}, track {}: {open} mm²", bit + 1);
            }
        }
    }
}

#[test]
fn a_blank_row_has_nothing_but_its_feed_hole() {
    let columns = Columns::new(PITCH, Theme::Light);
    let picture = tile(&[0x00], &columns);
    let feed = lines_around(&columns, FEED);
    for y in (0..picture.height).filter(|y| !feed.contains(y)) {
        for x in 1..picture.width {
            assert_eq!(red(&picture, x, y), red(&picture, 0, y), "x {x}, y {y}");
        }
    }
}

#[test]
fn the_paper_is_an_inch_wide() {
    for pitch in Columns::PITCHES {
        let columns = Columns::new(pitch, Theme::Light);
        let picture = tile(&[0x00], &columns);
        let [bench, ..] = Theme::Light.colours().bench;
        let paper = (0..picture.height).filter(|y| bench + 40 < red(&picture, 0, *y)).count();
        let width = paper as f64 * 2.54 / f64::from(pitch);
        assert!((width - WIDTH).abs() < 0.08, "{width} mm at pitch {pitch}");
    }
}

#[test]
fn columns_fit_together_without_a_seam_and_the_picture_into_the_bench() {
    for theme in THEMES {
        for pitch in Columns::PITCHES {
            let columns = Columns::new(pitch, theme);
            // Below 8 pixels the bridge of paper between two code holes is thinner than a pixel on either side of the border.
            let rows: &[u8] = if pitch < 8 { &[0x00; 3] } else { &[0x00, 0xff, 0xff, 0x55, 0xaa] };
            let picture = tile(rows, &columns);
            let pixel = |x: u32, y: u32| &picture.rgba[4 * (y * picture.width + x) as usize..][..4];
            for y in 0..picture.height {
                for border in (pitch..picture.width).step_by(pitch as usize) {
                    assert_eq!(pixel(border - 1, y), pixel(border, y), "pitch {pitch}, x {border}, y {y}");
                    assert_eq!(pixel(border, y), pixel(0, y), "pitch {pitch}, x {border}, y {y}");
                }
            }
            let [red, green, blue] = theme.colours().bench;
            for y in [0, picture.height - 1] {
                assert_eq!(pixel(0, y), [red, green, blue, 255], "pitch {pitch}");
            }
            assert!(picture.rgba.chunks(4).all(|pixel| pixel[3] == 255));
        }
    }
}
