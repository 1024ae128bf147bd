//! From blocks to spans: one example worked by hand for each mode that a tape can set, and for what cannot be told.

// The truth is worked out with the standard library's functions, not with those that the core uses.
#![allow(clippy::disallowed_methods)]

use nctape::format::value::Positive;
use nctape::format::{
    ArcCentre, ArcParameters, CurveKind, Declared, FeedCoding, Format, ParabolaParameters, SetPoint, Standard, explain,
};
use nctape::span::{Geometry, Span};
use nctape::{Severity, Tape};

/// Two places behind the decimal sign, signed, three motions at a time.
fn format() -> Format {
    Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42I+42J+42K+42F4S4T2M2*").classified("CAM 333")
}

fn run(format: &Format, blocks: &[&str]) -> Tape {
    let numbered = blocks.iter().enumerate().map(|(index, block)| format!("N{:03}{block}\n", index + 1));
    Tape::new(&format!("%\n{}", numbered.collect::<String>()), format)
}

fn ids(tape: &Tape, least: Severity) -> Vec<&'static str> {
    tape.diagnostics().iter().filter(|found| found.severity >= least).map(|found| found.id).collect()
}

fn arc(span: &Span) -> nctape::span::Arc {
    let Geometry::Arc(arc) = span.geometry else { panic!("an arc: {span:?}") };
    arc
}

fn degrees(span: &Span) -> f64 {
    arc(span).sweep.to_degrees().round()
}

#[test]
fn arcs_turn_as_seen_from_the_positive_third_axis_in_each_plane() {
    // A quarter of radius 10 from the first towards the second axis of the plane: counter-clockwise.
    for (plane, block, end) in [
        ("G17", "G03X-001000Y+001000I-001000J+000000", [-10.0, 10.0, 0.0]),
        ("G18", "G03X+001000Z-001000I+000000K-001000", [10.0, 0.0, -10.0]),
        ("G19", "G03Y-001000Z+001000J-001000K+000000", [0.0, -10.0, 10.0]),
    ] {
        let mut format = format();
        format.itemized.arc_centre = Some(ArcCentre::FromStart);
        let tape = run(&format, &["G01F0300", plane, block, "M30"]);
        assert_eq!(ids(&tape, Severity::Warning), [""; 0], "{plane}");
        let span = &tape.spans().list[0];
        assert_eq!((span.end, degrees(span)), (end, 90.0), "{plane}");
    }
}

#[test]
fn the_four_readings_of_the_centre() {
    // From (10, 0) a quarter counter-clockwise about the origin to (0, 10), in absolute dimensions.
    for (reading, parameters) in [
        (None, "I+000000J+000000"),
        (Some(ArcCentre::Absolute), "I+000000J+000000"),
        (Some(ArcCentre::FromStart), "I-001000J+000000"),
        (Some(ArcCentre::ToStart), "I+001000J+000000"),
        (Some(ArcCentre::Quadrant), "I+001000J+000000"),
    ] {
        let mut format = format();
        format.itemized.arc_centre = reading;
        let tape = run(&format, &["G01X+001000F0300", &format!("G03X+000000Y+001000{parameters}"), "M30"]);
        assert_eq!(ids(&tape, Severity::Warning), [""; 0], "{reading:?}");
        assert_eq!((arc(&tape.spans().list[1]).centre, degrees(&tape.spans().list[1])), ([0.0, 0.0], 90.0));
    }
}

#[test]
fn absolute_and_incremental_dimensions_change_places_by_g90_and_g91() {
    let format = Format::new(Standard::Iso2539, "N3G2XL42YL42F4M2*").classified("CAM 222");
    let tape = run(&format, &["G91G01X+001000F0300", "X+001000", "G90X+000500Y+000500", "G91Y-000500M30"]);
    let ends: Vec<[f64; 3]> = tape.spans().list.iter().map(|span| span.end).collect();
    assert_eq!(ends, [[10.0, 0.0, 0.0], [20.0, 0.0, 0.0], [5.0, 5.0, 0.0], [5.0, 0.0, 0.0]]);
}

#[test]
fn a_word_that_cannot_be_read_makes_a_stand_in_and_no_other_fault() {
    // I and J have too few digits: no two-block arc begins here.
    let tape = run(&format(), &["G01X+001000F0300", "G03X+000000Y+001000I+1J+0", "M30"]);
    assert_eq!(ids(&tape, Severity::Warning), ["NUM-01", "NUM-01"]);
    let span = &tape.spans().list[1];
    assert_eq!((span.substitute, span.feed, span.seconds), (true, None, None));

    // The second of six points cannot be read: the others pair as they should.
    let points = ["G06X+001000Y+001000", "X+20Y+0", "X+003000Y+001000", "X+004000Y+000000"];
    let tape = run(&format(), &[&["G01F0300"], &points[..], &["G01X+005000M30"]].concat());
    assert_eq!(ids(&tape, Severity::Warning), ["NUM-01", "NUM-01"]);
    // The second parabola begins where the first ends, which is not known either; from its end on all is known again.
    let spans: Vec<((usize, usize), bool)> =
        tape.spans().list.iter().map(|span| (span.blocks, span.substitute)).collect();
    assert_eq!(spans, [((1, 2), true), ((3, 4), true), ((5, 5), false)]);

    // A line with one such word is a guess, and a block whose only word it is leaves the time unknown.
    let tape = run(&format(), &["G01X+1000Y+002000F0300", "X+001000M30"]);
    assert!(tape.spans().list.iter().all(|span| span.substitute), "{:?}", tape.spans().list);
    let tape = run(&format(), &["G01X+001000F0300", "Y+1", "M30"]);
    assert_eq!((tape.spans().list.len(), tape.totals().seconds), (1, None));
}

#[test]
fn registers_are_loaded_with_the_value_itself() {
    let format = Format::new(Standard::Iso2539, "N3G2XL42YL42F4M2*").classified("CAM 222");
    let tape = run(&format, &["G91", "G01X+001000F0300", "G92X+000500", "X+000100M30"]);
    let last = &tape.spans().list[1];
    assert_eq!((last.start, last.end), ([5.0, 0.0, 0.0], [6.0, 0.0, 0.0]));
    assert_eq!(ids(&tape, Severity::Info), ["FUN-09"]);
}

#[test]
fn a_cubic_runs_through_three_points_in_successive_blocks() {
    // y = x (x - 1)(x - 2), its x in units of 10 and its y in units of 1, from 0 to 30: 0, 0, 0, 6. The next one is
    // straight, and of the last one only two points are there.
    let mut format = format();
    format.itemized.curves = Some([("G05".to_owned(), CurveKind::Cubic)].into());
    let points = ["G05X+001000Y+000000", "X+002000", "X+003000Y+000600", "X+004000", "X+005000", "X+006000"];
    let tape = run(&format, &[&["G01F0300"], &points[..], &["X+007000", "X+008000", "G01X+009000M30"]].concat());
    assert_eq!(ids(&tape, Severity::Info), ["MOT-12"]);
    let spans = &tape.spans().list;
    let blocks: Vec<_> = spans.iter().map(|span| (span.kind.name(), span.blocks, span.substitute)).collect();
    let expected =
        [("curve", (1, 3), false), ("curve", (4, 6), false), ("line", (7, 8), true), ("line", (9, 9), false)];
    assert_eq!(blocks, expected);
    // It leaves with 30 along and 6 up for each unit of its parameter, and arrives with 30 and 33.
    let Geometry::Curve { control } = spans[0].geometry else { panic!("a cubic") };
    assert_eq!(control, [[10.0, 2.0, 0.0], [20.0, -5.0, 0.0]]);
    assert_eq!(spans[0].end, [30.0, 6.0, 0.0]);
    assert!((spans[1].length - 30.0).abs() < 1e-12);
    assert_eq!(spans[0].seconds, Some(spans[0].length / 300.0 * 60.0));
    // It is least at x = 10 (1 + 1/√3), where it is -2/(3√3), and greatest on the way at 10 (1 - 1/√3).
    let (least, greatest) = spans[0].bounds();
    assert!((least[1] + 2.0 / 27f64.sqrt()).abs() < 1e-14 && greatest[1] == 6.0, "{least:?} {greatest:?}");

    // A block that cannot be read, a change of function and a parameter: each has its own fault, and the tape goes on.
    let tape = run(&format, &["G05X+001000F0300", "X+2", "X+003000", "G05X+004000I+000100", "G01X+005000M30"]);
    assert_eq!(ids(&tape, Severity::Warning), ["NUM-01", "MOT-12", "MOT-16"]);
    assert_eq!(tape.spans().list.iter().map(|span| span.substitute).collect::<Vec<_>>(), [true, true, false]);
    let tape = run(&format, &["G05X+000000F0300", "X+000000", "X+000000", "G01X+005000M30"]);
    assert_eq!((ids(&tape, Severity::Info), tape.spans().list.len()), (vec!["MOT-18"], 1));
    // An assigned code keeps its meaning.
    format.itemized.curves = Some([("G03".to_owned(), CurveKind::Cubic)].into());
    let tape = run(&format, &["G01F0300", "G03X+001000Y+001000I+000000J+001000", "M30"]);
    assert_eq!(degrees(&tape.spans().list[0]), 90.0);
}

#[test]
fn feeds_of_each_kind() {
    let seconds = |format: &Format, blocks: &[&str]| -> Vec<Option<f64>> {
        run(format, blocks).spans().list.iter().map(|span| span.seconds).collect()
    };
    // 10 mm at 300 mm/min; the reciprocal of a quarter minute; 0,5 mm a turn at 600 turns a minute.
    let blocks = ["G01X+001000F0300", "G93X+002000F0004", "G94X+003000F0600M30"];
    assert_eq!(seconds(&format(), &blocks), [Some(2.0), Some(15.0), Some(1.0)]);
    let by_turns = Format::new(Standard::Iso2539, "N3G2X+42F4S4M2*").classified("CAM 111");
    let blocks = ["G95S0600", "G01X+001000F0001", "G96S0200", "X+002000M30"];
    // Under constant cutting speed the turns are not known.
    assert_eq!(seconds(&by_turns, &blocks), [Some(1.0), None]);

    // Back to the coding of the format behind G93: 615 is 150 mm/min.
    let mut coded = Format::new(Standard::Iso2539, "N3G2X+42F3M2*").classified("CAM 111");
    coded.itemized.feed = Some(FeedCoding::Arithmetic);
    let tape = run(&coded, &["G93G01X+001000F004", "G94X+002000F615M30"]);
    assert_eq!(tape.spans().list[1].feed, Some(150.0));
}

#[test]
fn rapid_moves_have_a_time_where_the_rate_is_stated() {
    let mut format = format();
    let blocks = ["G00X+001000", "M30"];
    assert_eq!(run(&format, &blocks).totals().seconds, None);
    format.itemized.rapid = Some(Positive(6000.0));
    let totals = run(&format, &blocks).totals();
    assert_eq!((totals.rapid, totals.cutting, totals.seconds), (10.0, 0.0, Some(0.1)));
}

#[test]
fn a_rotary_axis_adds_no_length() {
    let format = Format::new(Standard::Iso2539, "N3G2X+42B+33F4M2*").classified("CAMD 222");
    let tape = run(&format, &["G01B+090000F0300", "X+001000M30"]);
    assert_eq!(tape.totals().cutting, 10.0);
    assert_eq!(tape.spans().end(0), [0.0, 0.0, 0.0, 90.0]);
}

/// U, V and W are motions parallel to X, Y and Z (ISO 2539 B.1): lengths, and no angles.
#[test]
fn a_secondary_axis_has_a_length_where_the_primary_ones_stand() {
    let mut format = Format::new(Standard::Iso2539, "N3G2X+33W+33B33F4M2*").classified("CAMD 433");
    format.itemized.feed = Some(FeedCoding::Direct);
    format.itemized.rapid = Some(Positive(2000.0));
    let blocks = ["G01X+003000F0100", "W-020000", "W+030000B090000", "X+007000W+034000", "B000000", "G00W+000000M30"];
    let tape = run(&format, &blocks);
    let spans: Vec<_> = tape.spans().list.iter().map(|span| (span.length, span.angular, span.seconds)).collect();
    let expected = [
        (3.0, false, 1.8),
        (20.0, false, 12.0),
        // The rotary axis goes along.
        (50.0, false, 30.0),
        (4.0, false, 2.4),
        (90.0, true, 54.0),
        (34.0, false, 1.02),
    ];
    assert_eq!(spans.len(), expected.len());
    for ((length, angular, seconds), (wanted, turns, time)) in spans.into_iter().zip(expected) {
        assert_eq!((length, angular), (wanted, turns));
        assert!(seconds.is_some_and(|seconds| (seconds - time).abs() < 1e-12), "{seconds:?} {time}");
    }
    assert_eq!((tape.totals().cutting, tape.totals().rapid), (77.0, 34.0));
}

#[test]
fn the_number_of_a_reciprocal_says_nothing_of_a_thread() {
    let mut format = Format::new(Standard::Iso2539, "N3G2X+33Y+33Z+33I+33J+33K+33F4S4T2M2*").classified("CAM 333");
    format.itemized.feed = Some(FeedCoding::TimeReciprocal);
    let blocks = ["G01X+010000F0030S0500M03", "G33Z-020000K+002000F0002", "Z-030000F0000", "M30"];
    let tape = run(&format, &blocks);
    assert!(!ids(&tape, Severity::Info).contains(&"FEED-03"), "{:?}", ids(&tape, Severity::Info));
    assert_eq!(tape.spans().list[1].feed, Some(1000.0));
}

/// Beyond 2^53 increments one of them may be no step of a number any more: no span is of length zero.
#[test]
fn a_step_that_no_number_shows_is_no_span() {
    let mut format = Format::new(Standard::Iso2539, "N3G2XD63YD63F4M2*").classified("CAM 222");
    format.itemized.set_point = Some(SetPoint::InOrder(vec![1e15]));
    let tape = run(&format, &["G01X+000000001F0300", "Y+000000001M30"]);
    assert!(tape.spans().list.iter().all(|span| span.length > 0.0), "{:?}", tape.spans().list);
    assert_eq!(tape.spans().list.len(), 1);
}

/// A to E turn, in turns or degrees as the classification says; U to W and P to R go along X, Y and Z. Each is an axis of
/// its own, in the order of the detail, and alone it goes at its own feed.
#[test]
fn every_letter_of_a_further_axis_is_read_and_shown() {
    for (letter, meaning) in [
        ('A', None),
        ('B', None),
        ('C', None),
        ('D', Some("angular dimension about a special axis")),
        ('E', Some("angular dimension about a special axis")),
        ('U', Some("secondary motion parallel to X")),
        ('V', Some("secondary motion parallel to Y")),
        ('W', Some("secondary motion parallel to Z")),
        ('P', Some("tertiary motion parallel to X")),
        ('Q', Some("tertiary motion parallel to Y")),
        ('R', Some("tertiary motion parallel to Z")),
    ] {
        for class in ["CAMD 222", "CAMR 222"] {
            let mut format = Format::new(Standard::Iso2539, &format!("N3G2X+42{letter}+33F4M2*")).classified(class);
            if let Some(meaning) = meaning {
                let letters = [(letter.to_string(), meaning.to_owned())].into();
                format.itemized.declared = Some(Declared { letters, ..Declared::default() });
            }
            assert!(explain(&format).diagnostics.is_empty(), "{:?}", explain(&format).diagnostics);
            // Half a unit: degrees or turns, or millimetres; 0,5 of them at 5 a minute take 6 seconds.
            let block = format!("G01{letter}+000500F0005");
            let tape = run(&format, &[&block, "X+001000M30"]);
            assert_eq!(ids(&tape, Severity::Info), [""; 0], "{letter} {class}");
            let letters: String = tape.control().axes.iter().map(|axis| axis.letter).collect();
            assert_eq!(letters, format!("XYZ{letter}"));
            assert_eq!(tape.spans().end(0), [0.0, 0.0, 0.0, 0.5]);
            let span = &tape.spans().list[0];
            assert_eq!((span.length, span.feed, span.seconds), (0.5, Some(5.0), Some(6.0)), "{letter}");
            // A length counts, an angle does not; it stands in the registers behind its block and the next.
            assert_eq!(tape.totals().cutting, if letter > 'E' { 10.5 } else { 10.0 }, "{letter}");
            for registers in tape.registers_of(0..2) {
                assert_eq!(registers.position[3], 0.5, "{letter}");
            }
        }
    }
}

/// By hand: from (10, 0) over (8, 6) to (0, 10) on the circle about the origin, and the other way round.
#[test]
fn arcs_through_a_point() {
    for (code, over, sweep) in [("G03", "X+000800Y+000600", 90.0), ("G02", "X+000600Y-000800", -270.0)] {
        let first = format!("{code}{over}");
        let tape = run(&format(), &["G01X+001000F0300", &first, "X+000000Y+001000", "M30"]);
        assert_eq!(ids(&tape, Severity::Warning), [""; 0]);
        let span = &tape.spans().list[1];
        assert_eq!((span.blocks, span.end, degrees(span)), ((1, 2), [0.0, 10.0, 0.0], sweep));
        assert!(arc(span).centre.iter().all(|at| at.abs() < 1e-12), "{:?}", arc(span).centre);
        assert!((span.length - 10.0 * sweep.abs().to_radians()).abs() < 1e-9);
    }
}

/// By hand: from (0, 0) over (10, 10) to (20, 0) the tangents meet at (10, 20); the next one begins there (4.2.3.2).
#[test]
fn parabolas_through_a_point_are_chained() {
    let points = ["G06X+001000Y+001000F0300", "X+002000Y+000000", "X+003000Y-001000", "X+004000Y+000000M30"];
    let tape = run(&format(), &points);
    assert_eq!(ids(&tape, Severity::Warning), [""; 0]);
    let spans: Vec<_> = tape.spans().list.iter().map(|span| (span.blocks, parabola(span), span.end)).collect();
    let expected = [((0, 1), [10.0, 20.0, 0.0], [20.0, 0.0, 0.0]), ((2, 3), [30.0, -20.0, 0.0], [40.0, 0.0, 0.0])];
    assert_eq!(spans, expected);
}

#[test]
fn helices_in_one_block_and_in_two() {
    // Half a turn of radius 10 with a rise of 4 along Z: hypot(10 pi, 4) long.
    let long = (std::f64::consts::PI * std::f64::consts::PI * 100.0 + 16.0).sqrt();
    let mut format = format();
    format.itemized.arc_centre = Some(ArcCentre::FromStart);
    let one = run(&format, &["G01F0300", "G03X+002000Y+000000Z+000400I+001000J+000000", "M30"]);
    let two = run(&format, &["G01F0300", "G03X+001000Y-001000Z+000200", "X+002000Y+000000Z+000400", "M30"]);
    for tape in [one, two] {
        assert_eq!(ids(&tape, Severity::Warning), [""; 0]);
        let span = &tape.spans().list[0];
        assert_eq!((span.end, degrees(span)), ([20.0, 0.0, 4.0], 180.0));
        assert!((span.length - long).abs() < 1e-9, "{}", span.length);
    }
    // A control of two axes at a time has none, and the third axis still gets there.
    let flat = format.classified("CAM 332");
    let tape = run(&flat, &["G01F0300", "G03X+002000Y+000000Z+000400I+001000J+000000", "M30"]);
    assert_eq!(ids(&tape, Severity::Error), ["MOT-02"]);
    assert_eq!((tape.spans().list[0].substitute, tape.spans().list[0].end), (true, [20.0, 0.0, 4.0]));
}

#[test]
fn an_arc_that_ends_where_it_starts() {
    let mut format = format();
    format.itemized.arc_centre = Some(ArcCentre::FromStart);
    let blocks = ["G01F0300", "G02X+000000Y+000000I+001000J+000000", "M30"];
    let tape = run(&format, &blocks);
    assert_eq!(ids(&tape, Severity::Info), ["MOT-11"]);
    assert_eq!(degrees(&tape.spans().list[0]), -360.0);
    format.itemized.full_circle = Some(false);
    assert!(run(&format, &blocks).spans().list.is_empty());
    // What else moves is not lost with it.
    let tape = run(&format, &["G01F0300", "G02X+000000Y+000000Z+001000I+001000J+000000", "Z+002000M30"]);
    assert_eq!(tape.spans().list[1].start, tape.spans().list[0].end);
}

#[test]
fn a_change_of_plane_leaves_an_arc_unfinished() {
    let tape = run(&format(), &["G01F0300", "G02X+001000Y+001000", "G18X+002000Z+001000", "G01X+003000M30"]);
    assert_eq!(ids(&tape, Severity::Error), ["MOT-07", "MOT-07"]);
}

/// Found by the properties: a letter was joined to a number of the block before, at whose offset it happened to stand.
#[test]
fn a_letter_is_joined_to_a_number_of_its_own_block_only() {
    let tape = Tape::new("M02\nY5\r\u{AE}O1N001", &format());
    let second = &tape.reading().blocks[1];
    let word = &tape.reading().words(second)[0];
    assert_eq!(&tape.text()[tape.reading().range(second, word)], "Y5");
}

fn parabola(span: &Span) -> [f64; 3] {
    let Geometry::Parabola { tangent } = span.geometry else { panic!("a parabola: {span:?}") };
    tangent
}

#[test]
fn arcs_by_angle_and_radius() {
    // Quarters of radius 10 about (0, 10): up to (10, 10), on by the long way, which is three quarters, and half a turn.
    let blocks = |quarter: &str, three: &str, half: &str| {
        let first = format!("G03X+001000Y+001000I{quarter}J+001000");
        let back = format!("G03X+000000Y+000000I{three}J+001000");
        [vec!["G01F0300".to_owned(), first, back, format!("G02X+000000Y+002000I{half}J+001000"), "M30".to_owned()]]
            .concat()
    };
    for (class, blocks) in [
        ("CAMD 333", blocks("+009000", "+027000", "+018000")),
        ("CAM 333", blocks("+009000", "+027000", "+018000")),
        ("CAMR 333", blocks("+000025", "+000075", "+000050")),
    ] {
        let mut format = format().classified(class);
        format.itemized.arc_parameters = Some(ArcParameters::AngleRadius);
        let blocks: Vec<&str> = blocks.iter().map(String::as_str).collect();
        let tape = run(&format, &blocks);
        assert_eq!(ids(&tape, Severity::Warning), [""; 0], "{class}");
        let spans = &tape.spans().list;
        assert_eq!(spans.iter().map(degrees).collect::<Vec<_>>(), [90.0, 270.0, -180.0]);
        for (span, centre) in spans.iter().zip([[0.0, 10.0], [0.0, 10.0], [0.0, 10.0]]) {
            // The ends are 10√2 apart, which is no number of increments: nothing is off by more than a rounding of f64.
            let off = (arc(span).centre[0] - centre[0]).hypot(arc(span).centre[1] - centre[1]);
            assert!(off < 1e-14, "{:?}", arc(span).centre);
        }
        assert!((spans[0].length - 5.0 * std::f64::consts::PI).abs() < 1e-13);
    }

    // A chord of 14.21 for ends that are 14.14 apart: both are said, a stand-in is drawn and the tape goes on.
    let mut format = format();
    format.itemized.arc_parameters = Some(ArcParameters::AngleRadius);
    let tape = run(&format, &["G01F0300", "G03X+001000Y+001000I+009000J+001005", "G01X+002000M30"]);
    let found = tape.diagnostics().into_iter().find(|found| found.severity == Severity::Error).expect("an error");
    assert!(found.id == "MOT-04" && found.message.contains("14.21") && found.message.contains("14.14"));
    assert_eq!(tape.spans().list.iter().map(|span| span.substitute).collect::<Vec<_>>(), [true, false]);
    // The third axis goes on as it does about a centre, and K says nothing.
    let tape = run(&format, &["G01F0300", "G03X+001000Y+001000Z+000400I+009000J+001000K+000100", "M30"]);
    assert_eq!(ids(&tape, Severity::Warning), ["MOT-16"]);
    assert!((tape.spans().list[0].length - (5.0 * std::f64::consts::PI).hypot(4.0)).abs() < 1e-13);
}

#[test]
fn parabolas_by_tangent_slope_and_focus() {
    // y = x²/4 from (-1, 0.25) to (2, 1): its tangents -x/2 - 0.25 and x - 1 meet in (0.5, -0.5), its focus is (0, 1).
    // From its start those are 1.5 and -0.75, 1 and 0.75 away.
    let blocks = |parameters| ["G00X-000100Y+000025".to_owned(), format!("G06X+000200Y+000100{parameters}F0300M30")];
    for (kind, reading, parameters) in [
        (None, None, "I+000050J-000050"),
        (None, Some(ArcCentre::FromStart), "I+000150J-000075"),
        (None, Some(ArcCentre::ToStart), "I-000150J+000075"),
        (Some(ParabolaParameters::Slope), None, "I-000050J+000100"),
        (Some(ParabolaParameters::Focus), None, "I+000000J+000100"),
        (Some(ParabolaParameters::Focus), Some(ArcCentre::FromStart), "I+000100J+000075"),
        (Some(ParabolaParameters::Focus), Some(ArcCentre::ToStart), "I-000100J-000075"),
    ] {
        let mut format = format();
        (format.itemized.parabola_parameters, format.itemized.arc_centre) = (kind, reading);
        let tape = run(&format, &blocks(parameters).each_ref().map(String::as_str));
        assert_eq!(ids(&tape, Severity::Warning), [""; 0], "{parameters}");
        let span = &tape.spans().list[1];
        let tangent = parabola(span);
        assert!((tangent[0] - 0.5).abs().max((tangent[1] + 0.5).abs()) < 1e-14 && tangent[2] == 0.0, "{tangent:?}");
        // The primitive of sqrt(1 + x²/4) is x/2 sqrt(1 + x²/4) + asinh(x/2).
        let long = 2f64.sqrt() + 1f64.asinh() + 0.5 * 1.25f64.sqrt() + 0.5f64.asinh();
        assert!((span.length - long).abs() < 1e-12, "{} {long}", span.length);
        assert_eq!(span.end, [2.0, 1.0, 0.0]);
    }
}

#[test]
fn a_parabola_lies_in_any_plane_in_space() {
    // The same one stood up along (0, 0.8, 0.6): (x, y) is (x, 0.8 y, 0.6 y).
    for (kind, parameters) in
        [(None, "I+000050J-000040K-000030"), (Some(ParabolaParameters::Focus), "I+000000J+000080K+000060")]
    {
        let mut format = format();
        format.itemized.parabola_parameters = kind;
        let tape =
            run(&format, &["G00X-000100Y+000020Z+000015", &format!("G06X+000200Y+000080Z+000060{parameters}F0300M30")]);
        assert_eq!(ids(&tape, Severity::Warning), [""; 0]);
        let tangent = parabola(&tape.spans().list[1]);
        for (given, right) in tangent.iter().zip([0.5, -0.4, -0.3]) {
            assert!((given - right).abs() < 1e-14, "{tangent:?}");
        }
    }
    // In ZX the slopes are dX/dZ: from Z 0, X 0 with the slope 1 to Z 10, X 5 with the slope 0 by Z 5, X 5. What Y does
    // is in proportion.
    let mut format = format();
    format.itemized.parabola_parameters = Some(ParabolaParameters::Slope);
    let tape = run(&format, &["G18F0300", "G06X+000500Y+000800Z+001000I+000100J+000000", "M30"]);
    assert_eq!((ids(&tape, Severity::Info), parabola(&tape.spans().list[0])), (vec![], [5.0, 4.0, 5.0]));
}

#[test]
fn a_parabola_without_parameters_to_match_is_a_stand_in_and_the_tape_goes_on() {
    for (kind, parameters) in [
        (ParabolaParameters::Tangent, "I+000500J+000000"),
        (ParabolaParameters::Slope, "I+000100J+000100"),
        (ParabolaParameters::Slope, "I+000000J+000100"),
        (ParabolaParameters::Slope, "J+000100"),
        (ParabolaParameters::Focus, "I+000500J+000000"),
        (ParabolaParameters::Focus, "I+000000J+000000"),
        (ParabolaParameters::Focus, "I+002000J+000000"),
    ] {
        let mut format = format();
        format.itemized.parabola_parameters = Some(kind);
        let tape = run(&format, &[&format!("G06X+001000Y+000000{parameters}F0300"), "G01Y+001000M30"]);
        assert_eq!(ids(&tape, Severity::Warning), ["MOT-13"], "{kind:?} {parameters}");
        assert_eq!(tape.spans().list.iter().map(|span| span.substitute).collect::<Vec<_>>(), [true, false]);
    }
}
