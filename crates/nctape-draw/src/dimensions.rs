//! What the standards say of the tape, in millimetres.
//!
//! The tape is that of ISO 1154, EIA RS-227 and ECMA-10: one inch wide, eight tracks, holes on a grid of a tenth of an inch.
//! The numbers and tolerances are those which the service manual of the Facit 4070 tape punch gives for it,
//! as quoted by A. Duell on the classiccmp mailing list; below, "Facit 4070" is this quotation.
//! The text of the standards themselves was not at hand.
//!
//! All distances across the tape are counted from the reference edge, the edge beside tracks 1 to 3.
//!
//! ```text
//! far edge        25.40  ─────────────
//! track 8         22.66    ●
//! track 7         20.12    ●
//! track 6         17.58    ●
//! track 5         15.04    ●
//! track 4         12.50    ●
//! feed hole        9.96    •
//! track 3          7.42    ●
//! track 2          4.88    ●
//! track 1          2.34    ●
//! reference edge   0.00  ─────────────
//! ```
//!
//! Many drawings centre the nine holes between the edges, which puts the feed hole at 10.16:
//! 0.20 mm off, twice what the tolerance allows.

/// A length and how far a real tape may depart from it, in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimension {
    /// The length that is aimed at, and drawn.
    pub nominal: f64,
    /// How much shorter it may be.
    pub minus: f64,
    /// How much longer it may be.
    pub plus: f64,
}

impl Dimension {
    const fn symmetric(nominal: f64, tolerance: f64) -> Dimension {
        Dimension { nominal, minus: tolerance, plus: tolerance }
    }

    /// Whether a measured length is within the tolerance.
    pub fn admits(self, measured: f64) -> bool {
        self.nominal - self.minus <= measured && measured <= self.nominal + self.plus
    }
}

/// Tracks across the tape; the feed holes are not counted as one.
pub const TRACKS: u8 = 8;

/// From edge to edge: 1.000 ± 0.003 inch. Facit 4070; ECMA-10 knows this width alone.
pub const WIDTH: Dimension = Dimension::symmetric(25.40, 0.08);

/// From one row to the next along the tape: 0.1 inch, any multiple of it ± 0.05 mm. Facit 4070.
pub const ROW_PITCH: Dimension = Dimension::symmetric(2.54, 0.05);

/// From one track to the next across the tape, and from the feed hole to tracks 3 and 4:
/// 0.1 inch, any multiple of it ± 0.05 mm. Facit 4070.
pub const TRACK_PITCH: Dimension = Dimension::symmetric(2.54, 0.05);

/// Diameter of a code hole: 0.072 inch. Facit 4070; the programs `ptap2dxf` and `Punched-Tape` have the same nominal.
pub const CODE_HOLE: Dimension = Dimension::symmetric(1.83, 0.05);

/// Diameter of a feed hole: 0.046 inch. Facit 4070; the programs `ptap2dxf` and `Punched-Tape` have the same nominal.
pub const FEED_HOLE: Dimension = Dimension { nominal: 1.17, minus: 0.025, plus: 0.05 };

/// From the reference edge to the line of the feed holes: 0.392 inch. Facit 4070.
///
/// The feed hole is in line with the code holes of its row: advanced feed holes belong to the typesetters' six-track tape.
pub const FEED_LINE: Dimension = Dimension::symmetric(9.96, 0.10);

/// The last track between the reference edge and the feed holes.
const TRACKS_BELOW_FEED: u8 = 3;

/// The nominal distance of a track's centre line from the reference edge; `None` where there is no such track.
///
/// ```
/// use nctape_draw::dimensions::track_centre_mm;
///
/// assert_eq!(track_centre_mm(4), Some(12.50));
/// assert_eq!(track_centre_mm(9), None);
/// ```
pub fn track_centre_mm(track: u8) -> Option<f64> {
    if !(1..=TRACKS).contains(&track) {
        return None;
    }
    // The feed hole stands where a track would: it takes the place between tracks 3 and 4.
    let pitches = if track <= TRACKS_BELOW_FEED {
        f64::from(track) - f64::from(TRACKS_BELOW_FEED + 1)
    } else {
        f64::from(track - TRACKS_BELOW_FEED)
    };
    Some(FEED_LINE.nominal + pitches * TRACK_PITCH.nominal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tracks_are_where_the_standard_puts_them() {
        let listed = [2.34, 4.88, 7.42, 12.50, 15.04, 17.58, 20.12, 22.66];
        for (track, millimetres) in (1..).zip(listed) {
            let centre = track_centre_mm(track).unwrap();
            assert!((centre - millimetres).abs() < 1e-9, "track {track}: {centre}");
        }
    }

    #[test]
    fn there_is_no_track_beside_the_eight() {
        assert_eq!(track_centre_mm(0), None);
        assert_eq!(track_centre_mm(9), None);
        assert_eq!(track_centre_mm(255), None);
    }

    #[test]
    fn inches_and_millimetres_agree() {
        let inches = [
            (WIDTH, 1.000),
            (ROW_PITCH, 0.100),
            (TRACK_PITCH, 0.100),
            (CODE_HOLE, 0.072),
            (FEED_HOLE, 0.046),
            (FEED_LINE, 0.392),
        ];
        for (dimension, inch) in inches {
            assert!((dimension.nominal - inch * 25.4).abs() < 0.005, "{dimension:?}");
        }
    }

    #[test]
    fn centred_holes_would_be_out_of_tolerance() {
        assert!(FEED_LINE.admits(10.05));
        assert!(!FEED_LINE.admits(WIDTH.nominal * 4.0 / 10.0));
    }
}
