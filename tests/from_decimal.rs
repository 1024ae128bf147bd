//! Decimal G-code as tapes: one example worked by hand for each thing that a format decides, and random tapes there and
//! back.

#[path = "support/random_tape.rs"]
mod random_tape;

use nctape::convert::{Dialect, from_decimal, to_decimal};
use nctape::format::{
    ArcCentre, ArcFeed, ArcParameters, Dimensions, Dwell, DwellUnit, FeedCoding, FeedUnit, Format, Itemized, Standard,
    TimeScale,
};
use nctape::span::{Geometry, SpanKind};
use nctape::{Severity, Tape};
use random_tape::random_tape;

fn format() -> Format {
    let mut format = Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42I+42J+42K+42F4S4T2M2*").classified("CAM 333");
    format.itemized.arc_centre = Some(ArcCentre::FromStart);
    format.itemized.full_circle = Some(true);
    format
}

/// The blocks of a tape whose G-code has nothing wrong with it, and which has nothing wrong itself.
fn blocks(format: &Format, source: &str) -> Vec<String> {
    let converted = from_decimal(source, format);
    let said: Vec<&str> = converted.diagnostics.iter().map(|found| found.message.as_str()).collect();
    assert!(said.is_empty(), "{said:?}\n{}", converted.text);
    let tape = Tape::new(&converted.text, format);
    let found = tape.diagnostics().into_iter().filter(|found| found.severity > Severity::Info && found.id != "TAPE-10");
    let found: Vec<String> = found.map(|found| format!("{} {}", found.id, found.message)).collect();
    assert!(found.is_empty(), "{found:?}\n{}", converted.text);
    converted.text.lines().skip(1).map(str::to_owned).collect()
}

#[test]
fn coordinates_have_the_digits_of_the_format() {
    let source = "G21 G90\nN10 G0 X1 Y-2.5\nG91 G1 X.5 Y0 F100 (CUT)\nX.5\nM30\n";
    let absolute =
        ["N001 G00 X+000100 Y-000250", "N002 G01 X+000150 Y-000250 F0100 (CUT)", "N003 X+000200", "N004 M30"];
    assert_eq!(blocks(&format(), source), absolute);

    let mut incremental = Format::new(Standard::Rs274, "n3 g2 x+14 y+14 f4 m2*");
    incremental.itemized.dimensions = Some(Dimensions::Incremental);
    let blocks = blocks(&incremental, "G20\nG0 X1. Y-2.5\nG1 X1.5 F100\nM30");
    assert_eq!(blocks, ["n001 g00 x+10000 y-25000", "n002 g01 x+05000 f0100", "n003 m30"]);
}

#[test]
fn units_are_converted() {
    assert_eq!(blocks(&format(), "G20\nG1 X1. F10.\n"), ["N001 G01 X+002540 F0254"]);
}

/// A system with tabulation has tabs, one without addresses no letters.
#[test]
fn tabs_and_letters_are_those_of_the_system() {
    let tabs = Format::new(Standard::Iso2539, "N3.G2.X+42.Y+42.F4.M2*").classified("CSM 222");
    assert_eq!(blocks(&tabs, "G1 X1. F100\nM30"), ["N001\tG01\tX+000100\t\tF0100", "N002\t\t\t\t\tM30"]);
    let columns = Format::new(Standard::Iso2539, "N3.G2.X+42.Y+42.F4.M2*").classified("CTM 222");
    assert_eq!(blocks(&columns, "G1 Y1. F100\nM30"), ["001\t01\t\t+000100\t0100", "002\t\t\t\t\t30"]);
}

#[test]
fn a_centre_is_said_by_the_reading_of_the_format() {
    let source = "G0 X10.0\nG3 X0 Y10.0 I-10.0 F100\n";
    for (reading, words) in [
        (ArcCentre::FromStart, "I-001000 J+000000"),
        (ArcCentre::ToStart, "I+001000 J+000000"),
        (ArcCentre::Absolute, "I+000000 J+000000"),
        (ArcCentre::AsDimensions, "I+000000 J+000000"),
        (ArcCentre::Quadrant, "I+001000 J+000000"),
    ] {
        let mut format = format();
        format.itemized.arc_centre = Some(reading);
        let arc = format!("N002 G03 X+000000 Y+001000 {words} F0100");
        assert_eq!(blocks(&format, source)[1], arc, "{reading:?}");
    }
    // The same by its radius, and by coordinates of the centre.
    for source in ["G0 X10.0\nG3 X0 Y10.0 R10.0 F100\n", "G0 X10.0\nG90.1 G3 X0 Y10.0 I0 J0 F100\n"] {
        assert_eq!(blocks(&format(), source)[1], "N002 G03 X+000000 Y+001000 I-001000 J+000000 F0100");
    }
}

/// By hand: from (10, 0) three quarters about the origin to (0, -10) through (0, 10) and (-10, 0).
#[test]
fn a_control_of_one_quadrant_gets_an_arc_in_pieces() {
    let mut format = format();
    format.itemized.arc_centre = Some(ArcCentre::Quadrant);
    let wanted = [
        "N001 G00 X+001000",
        "N002 G03 X+000000 Y+001000 I+001000 J+000000 F0100",
        "N003 X-001000 Y+000000 I+000000 J+001000",
        "N004 X+000000 Y-001000 I+001000 J+000000",
    ];
    assert_eq!(blocks(&format, "G0 X10.0\nG3 X0 Y-10.0 I-10.0 F100\n"), wanted);
}

/// A format without I and J, or with others than the centre, has arcs through a point: here halfway, at 45 degrees.
#[test]
fn without_a_centre_an_arc_is_two_blocks() {
    let bare = Format::new(Standard::Iso2539, "N3G2X+42Y+42F4M2*").classified("CAM 222");
    let mut angle = format();
    angle.itemized.arc_parameters = Some(ArcParameters::AngleRadius);
    for format in [bare, angle] {
        let blocks = blocks(&format, "G0 X10.0\nG3 X0 Y10.0 I-10.0 F100\n");
        assert_eq!(blocks[1..], ["N002 G03 X+000707 Y+000707 F0100", "N003 X+000000 Y+001000"]);
    }
}

#[test]
fn planes_splines_and_dwells() {
    let mut format = format();
    format.itemized.dwell = Some(Dwell { address: 'X', unit: DwellUnit::Seconds });
    let source = "G18 G2 X10.0 Z10.0 I10.0 K0 F100\nG17 G5.1 X30.0 Y0 I10.0 J10.0\nG4 P1.5\nM30";
    let wanted = [
        "N001 G18",
        "N002 G02 X+001000 Z+001000 I+001000 K+000000 F0100",
        "N003 G06 X+003000 Y+000000 I+001000 J+001000",
        "N004 G04 X+000150",
        "N005 M30",
    ];
    assert_eq!(blocks(&format, source), wanted);
}

/// By the printed tables: 150 is 615, 315 is 50; a line of 10 mm at 100 mm/min has 10 a minute.
#[test]
fn feeds_are_coded_as_the_format_says() {
    let feed = |coding: FeedCoding, digits: &str| {
        let mut format = format();
        format.detail = format.detail.replace("F4", digits);
        format.itemized.feed = Some(coding);
        format
    };
    assert_eq!(blocks(&feed(FeedCoding::Arithmetic, "F3"), "G1 X1.0 F150")[0], "N001 G01 X+000100 F615");
    assert_eq!(blocks(&feed(FeedCoding::Geometric, "F2"), "G1 X1.0 F315")[0], "N001 G01 X+000100 F50");
    let mut reciprocal = feed(FeedCoding::TimeReciprocal, "F4");
    reciprocal.itemized.arc_feed = Some(ArcFeed::Radians);
    reciprocal.itemized.time_scale = Some(TimeScale(10));
    let lines = blocks(&reciprocal, "G1 X10.0 F100\nX20.0\nG3 X10.0 Y10.0 I-10.0 J0 F200");
    // An arc of radius 10 at 200 mm/min: 20 radians a minute.
    let wanted =
        ["N001 G01 X+001000 F0100", "N002 X+002000 F0100", "N003 G03 X+001000 Y+001000 I-001000 J+000000 F0200"];
    assert_eq!(lines, wanted);
    let mut turns = Format::new(Standard::Rs274, "n3 g2 x+42 f12 s4 m2*");
    turns.itemized.feed_unit = Some(FeedUnit::PerRevolution);
    assert_eq!(blocks(&turns, "G20 S500 M3\nG1 X1.0 F100")[1], "n002 g01 x+000100 f020");
}

#[test]
fn functions_keep_their_meaning() {
    let source = "T3 M6\nS600 M3 M8\nG0 X1.0 M5\nM48\n/G0 X2.0\nG0 X3.0\nM30";
    let converted = from_decimal(source, &format());
    let wanted = "%\nN001 T03 M06\nN002 S0600 M03\nN003 M08\nN004 M05\nN005 G00 X+000100\n/N006 G00 X+000200\nN007 G00 \
                  X+000300\nN008 M30\n";
    assert_eq!(converted.text, wanted);
    let found: Vec<_> = converted.diagnostics.iter().map(|found| (found.id, &source[found.range.clone()])).collect();
    assert_eq!(found, [("CONV-02", "M48")]);
}

/// A skipped line that is incremental on one side alone moves all that follows; a feed between two codes is rounded.
#[test]
fn what_is_written_otherwise_is_said() {
    let mut incremental = format();
    incremental.detail = incremental.detail.replace("X+42", "XD42");
    let rules = |source: &str, format: &Format| -> Vec<&'static str> {
        from_decimal(source, format).diagnostics.iter().map(|found| found.id).collect()
    };
    let (absolute, relative) = ("/G0 X1.0\nG0 X2.0\n", "G91\n/G0 X1.0\nG0 X2.0\n");
    assert_eq!((rules(absolute, &format()), rules(absolute, &incremental)), (vec![], vec!["CONV-05"]));
    assert_eq!((rules(relative, &format()), rules(relative, &incremental)), (vec!["CONV-05"], vec![]));
    assert_eq!(rules("/G0 Y1.0\nG0 X2.0\n", &incremental), [""; 0], "Y is absolute there");
    let found = from_decimal("G1 X1.0 F100.4\nX2.0 F200\nS600 M3\n", &format()).diagnostics;
    assert_eq!((found[0].id, found[0].range.clone()), ("CONV-10", 0..14));
    // 0,4 of 100,4.
    assert!(found[0].message.contains("up to 0.40 % off"), "{}", found[0].message);
    // What is said behind the last block stands there.
    assert!(from_decimal("M30\n(END)\n", &format()).text.ends_with("M30 (END)\n"));
}

#[test]
fn what_does_not_fit_stops_the_tape() {
    for (source, at, rule) in [
        ("G1 X1.0 F100\nX10000.0\n", "X10000.0", "CONV-09"),
        ("G1 X1.0\n", "G1 X1.0", "CONV-09"),
        ("G1 X1.0 F100000\n", "G1 X1.0 F100000", "CONV-09"),
        ("G81 X1.0 R1 Z-2.0 F100\n", "G81 X1.0 R1 Z-2.0 F100", "CONV-01"),
        ("G2 X1.0 I5.0 F100\n", "G2 X1.0 I5.0 F100", "CONV-01"),
        ("#1=5\n", "#1=5", "CONV-01"),
    ] {
        let converted = from_decimal(source, &format());
        assert!(converted.text.ends_with("M00 (NOT CONVERTED)\n"), "{source}: {}", converted.text);
        let worst = converted.diagnostics.iter().find(|found| found.severity == Severity::Error).expect("an error");
        assert_eq!((worst.id, &source[worst.range.clone()]), (rule, at));
    }
}

#[test]
fn lines_and_blocks_are_linked() {
    let source = "G21\nG0 X1.0\nM30\n";
    let converted = from_decimal(source, &format());
    let linked = converted.map.iter().map(|(from, to)| (&source[from.clone()], &converted.text[to.clone()]));
    assert_eq!(linked.collect::<Vec<_>>(), [("G21", ""), ("G0 X1.0", "N001 G00 X+000100\n"), ("M30", "N002 M30\n")]);
}

/// A tape as decimal G-code, and that as a tape again, for another format: the spans are the same.
#[test]
fn random_tapes_come_back() {
    let places = |format: &Format| {
        if format.detail.contains("52") {
            "52"
        } else if format.detail.contains("34") {
            "34"
        } else {
            "43"
        }
    };
    let mut arcs = 0;
    for number in 2000..2200 {
        let tape = random_tape(number);
        let digits = places(&tape.format);
        let inch = tape.format.standard == Standard::Rs274 || tape.format.classification.as_deref() == Some("CSI 333");
        let (dimensions, kind) =
            if number % 2 == 0 { (Dimensions::Absolute, '+') } else { (Dimensions::Incremental, 'D') };
        let lengths: String = "XYZIJK".chars().map(|letter| format!("{letter}{kind}{digits}")).collect();
        let other = Format {
            itemized: Itemized {
                set_point: tape.format.itemized.set_point.clone(),
                dimensions: Some(dimensions),
                arc_centre: Some(
                    [ArcCentre::FromStart, ArcCentre::ToStart, ArcCentre::AsDimensions][number as usize % 3],
                ),
                helix: Some(true),
                full_circle: Some(true),
                feed: Some(FeedCoding::Arithmetic),
                ..Itemized::default()
            },
            ..Format::new(Standard::Iso2539, &format!("N6G2{lengths}F5S4T2M2*")).classified(if inch {
                "CAI 333"
            } else {
                "CAM 333"
            })
        };
        let decimal = to_decimal(&tape.source, &tape.format, Dialect::LinuxCnc);
        let back = from_decimal(&decimal.text, &other);
        let errors = back.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        let errors: Vec<&str> = errors.map(|found| found.message.as_str()).collect();
        // A feed beyond the greatest code, which a random F per revolution may be.
        if errors.iter().any(|message| message.contains("has no code in F: the greatest")) {
            continue;
        }
        assert!(errors.is_empty(), "{errors:?}\n{}\n{}", decimal.text, back.text);
        let (one, two) = (Tape::new(&tape.source, &tape.format), Tape::new(&back.text, &other));
        let mut others = two.spans().list.iter();
        for span in &one.spans().list {
            // A curve that LinuxCNC lacks has become many spans, of which the last one ends where it does.
            let close = |one: [f64; 3], two: [f64; 3]| (0..3).all(|axis| (one[axis] - two[axis]).abs() < 1e-9);
            let found = others.by_ref().find(|other| close(other.end, span.end));
            let found = found.unwrap_or_else(|| panic!("{span:?} is lost\n{}\n{}", decimal.text, back.text));
            match (span.geometry, found.geometry) {
                (Geometry::Arc(one), Geometry::Arc(two)) => {
                    assert_eq!(one.plane, two.plane);
                    let off = (0..2).map(|axis| one.centre[axis] - two.centre[axis]).fold(0.0, libm::hypot);
                    assert!(off < 0.02 && (one.sweep - two.sweep).abs() < 0.05, "{span:?} {found:?}");
                    arcs += 1;
                }
                (Geometry::Line, Geometry::Line) => {
                    assert_eq!(span.kind == SpanKind::Rapid, found.kind == SpanKind::Rapid, "{span:?} {found:?}");
                    if let (Some(feed), Some(other), SpanKind::Line) = (span.feed, found.feed, span.kind) {
                        // Four digits of the code.
                        assert!((feed / other - 1.0).abs() < 1e-3, "{span:?} {found:?}");
                    }
                }
                _ => {}
            }
        }
    }
    assert!(arcs > 500, "{arcs}");
}
