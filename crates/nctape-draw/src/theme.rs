//! The colours of the bench and of the paper on it.

/// Red, green and blue, each from 0 to 255, in sRGB.
pub type Rgb = [u8; 3];

/// The light in which the tape lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Theme {
    /// A slate bench by day.
    Light,
    /// A dark bench under a lamp. The paper stays paper, a little dimmer.
    Dark,
}

/// What a picture of tape is painted with.
///
/// The page paints its own surroundings with `bench`, so that a picture has no visible border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colours {
    /// The surface under the tape, seen around it and through its holes.
    pub bench: Rgb,
    /// The bench where the tape keeps the light from it.
    pub shadow: Rgb,
    /// The paper in its middle.
    pub paper: Rgb,
    /// The paper where it bends away from the light, towards its edges.
    pub paper_shade: Rgb,
    /// A cut edge of the paper that faces the light.
    pub cut: Rgb,
}

impl Theme {
    /// The colours of this theme.
    ///
    /// Paper and bench have a contrast of at least 4.5 to 1 (WCAG 2.2, success criterion 1.4.3),
    /// although 3 to 1 would do for a picture (1.4.11): the pattern of the holes is there to be read.
    pub const fn colours(self) -> Colours {
        match self {
            Theme::Light => Colours {
                bench: [0x4c, 0x58, 0x63],
                shadow: [0x1e, 0x25, 0x2d],
                paper: [0xef, 0xe0, 0xbb],
                paper_shade: [0xe3, 0xd2, 0xa9],
                cut: [0xfc, 0xf3, 0xd9],
            },
            Theme::Dark => Colours {
                bench: [0x20, 0x26, 0x2d],
                shadow: [0x08, 0x0a, 0x0d],
                paper: [0xd9, 0xca, 0xa4],
                paper_shade: [0xcb, 0xbb, 0x93],
                cut: [0xe9, 0xdd, 0xbd],
            },
        }
    }
}

/// The colour a share of the way from one to another; 0 is the first, 1 the second.
pub(crate) fn mix(from: Rgb, to: Rgb, share: f64) -> Rgb {
    [0, 1, 2].map(|channel| {
        let (from, to) = (f64::from(from[channel]), f64::from(to[channel]));
        (from + (to - from) * share).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance in thousandths of the lightest, from a table for sixteen steps of sRGB
    /// (IEC 61966-2-1: ((c + 0.055) / 1.055) ^ 2.4), read between its entries.
    fn luminance(colour: Rgb) -> f64 {
        const STEPS: [f64; 16] =
            [0.0, 5.6, 15.9, 33.1, 57.8, 90.8, 132.9, 184.5, 246.2, 318.5, 401.9, 496.9, 603.8, 723.1, 855.0, 1000.0];
        let linear = colour.map(|channel| {
            let place = f64::from(channel) / 17.0;
            let below = place as usize;
            let above = (below + 1).min(STEPS.len() - 1);
            STEPS[below] + (STEPS[above] - STEPS[below]) * place.fract()
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    /// The contrast ratio of WCAG 2.2.
    fn contrast(lighter: Rgb, darker: Rgb) -> f64 {
        (luminance(lighter) + 50.0) / (luminance(darker) + 50.0)
    }

    #[test]
    fn holes_stand_out_against_the_darkest_paper() {
        for theme in [Theme::Light, Theme::Dark] {
            let colours = theme.colours();
            let ratio = contrast(colours.paper_shade, colours.bench);
            assert!(4.5 <= ratio, "{theme:?}: {ratio}");
        }
    }

    #[test]
    fn paper_is_dimmer_on_the_dark_bench_and_still_paper() {
        let (light, dark) = (Theme::Light.colours(), Theme::Dark.colours());
        assert!(luminance(dark.paper) < luminance(light.paper));
        assert!(luminance(dark.paper) > 500.0);
        for paper in [light.paper, dark.paper] {
            assert!(paper[0] > paper[1] && paper[1] > paper[2], "buff: {paper:?}");
        }
    }
}
