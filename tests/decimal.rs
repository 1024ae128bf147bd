//! Tapes as decimal G-code for LinuxCNC: one example worked by hand for each kind of word, and what holds for all.

#[path = "support/random_tape.rs"]
mod random_tape;

use nctape::convert::{Converted, Dialect, to_decimal};
use nctape::format::{
    ArcCentre, ArcFeed, CurveKind, Dimensions, Dwell, DwellUnit, FeedCoding, FeedUnit, Format, SetPoint, SpindleCoding,
    Standard,
};
use nctape::{Tape, presets};
use random_tape::random_tape;
use std::collections::BTreeMap;

/// Two places behind the decimal sign, signed, centres from the start.
fn format() -> Format {
    let mut format = Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42I+42J+42K+42F3S3T2M2*").classified("CAM 333");
    format.itemized.arc_centre = Some(ArcCentre::FromStart);
    format
}

/// RS-274, with F to hundredths.
fn eia_feed() -> Format {
    Format::new(Standard::Rs274, "n3 g2 x+42 y+42 z+42 f12 s3 t2 m2*")
}

fn converted(format: &Format, blocks: &[&str]) -> Converted {
    let numbered = blocks.iter().enumerate().map(|(index, block)| match block.strip_prefix('/') {
        Some(block) => format!("/N{:03}{block}\n", index + 1),
        None => format!("N{:03}{block}\n", index + 1),
    });
    to_decimal(&format!("%\n{}", numbered.collect::<String>()), format, Dialect::LinuxCnc)
}

/// What the blocks give, without the head and the last `%`.
fn body(format: &Format, blocks: &[&str]) -> Vec<String> {
    let text = converted(format, blocks).text;
    let lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let modes = lines.iter().position(|line| line.starts_with("G2")).expect("the modes");
    assert_eq!((lines[0].as_str(), lines.last().map(String::as_str)), ("%", Some("%")));
    lines[modes + 1..lines.len() - 1].to_vec()
}

fn rules(format: &Format, blocks: &[&str]) -> Vec<&'static str> {
    converted(format, blocks).diagnostics.iter().map(|found| found.id).collect()
}

#[test]
fn the_head_says_unit_modes_and_where_the_tool_stands() {
    let mut format = format();
    format.itemized.set_point = Some(SetPoint::InOrder(vec![10.0, 0.0, -2.5]));
    let text = converted(&format, &["M30"]).text;
    assert!(
        text.contains("(Before the first block the tool stands at X10.00 Y0.00 Z-2.50)\nG21 G17 G90 G91.1 "),
        "{text}"
    );
    let inches = Format::new(Standard::Rs274, "n3 g2 x+14 y+14 m2*");
    assert!(converted(&inches, &["m30"]).text.contains("\nG20 G17 G90 G91.1 G40 G49 G61 G80 G94 G97\n"));
}

#[test]
fn coordinates_are_absolute_with_the_places_of_the_increment() {
    let blocks = ["G01X+001000Y-000005F300", "Y+000000", "G00Z+000150", "M30"];
    let lines = ["N001 G1 X10.00 Y-0.05 F300", "N002 G1 Y0.00", "N003 G0 Z1.50", "N004 M30"];
    assert_eq!(body(&format(), &blocks), lines);

    let mut incremental = Format::new(Standard::Rs274, "n3 g2 x+14 y+14 f3 m2*");
    incremental.itemized.dimensions = Some(Dimensions::Incremental);
    incremental.itemized.set_point = Some(SetPoint::InOrder(vec![1.0, 1.0]));
    let lines = ["N001 G1 X1.5000 F100", "N002 G1 X2.0000", "N003 G1 Y0.9999"];
    assert_eq!(body(&incremental, &["g01 x+05000 f100", "x+05000", "y-00001"]), lines);
}

/// That the tool stands there already is an assumption of the format: the tape names the place, and so does the text.
#[test]
fn a_block_that_names_where_the_tool_stands_is_written() {
    assert_eq!(body(&format(), &["G00X+000000Y+000000"]), ["N001 G0 X0.00 Y0.00"]);
    assert_eq!(body(&format(), &["G01X+000000F100"]), ["N001 G1 X0.00 F100"]);
    assert_eq!(body(&format(), &["G01F100"]), ["N001"]);
}

#[test]
fn arcs_in_three_planes_full_circles_and_helices() {
    let mut format = format();
    format.itemized.helix = Some(true);
    format.itemized.full_circle = Some(true);
    let blocks = [
        "G01F100",
        "G02X+001000Y+001000I+001000J+000000",
        "G18G03X+000000Z+001000I+000000K+001000",
        "G19G02Y+002000I+000000J+000500K+000000",
        "G17G03X+000000Y+002000I+000500J+000000",
        "G02X+000000Y+002000Z+000000I+000500J+000000",
    ];
    let lines = [
        "N001",
        "N002 G2 X10.00 Y10.00 I10 J0 F100",
        "N003 G18 G3 X0.00 Z10.00 K10 I0",
        "N004 G19 G2 Y20.00 Z10.00 J5 K0",
        "N005 G17 G3 X0.00 Y20.00 I5 J0",
        "N006 G2 X0.00 Y20.00 Z0.00 I5 J0",
    ];
    let written = body(&format, &blocks);
    // The third block does not lie on a circle: X+10 to 0 about Z+10 does.
    assert_eq!(written[2], lines[2]);
    assert_eq!(written[..2], lines[..2]);
    assert_eq!(written[3..], lines[3..]);
}

/// By hand: (0, 0), (10, 10), (20, 0) are on the circle about (10, 0).
#[test]
fn an_arc_of_two_blocks_is_one_line_linked_to_both() {
    let blocks = ["G02X+001000Y+001000F100", "X+002000Y+000000"];
    assert_eq!(body(&format(), &blocks), ["N001", "N002 G2 X20.00 Y0.00 I10 J0 F100"]);
    let converted = converted(&format(), &blocks);
    let arc = converted.text.find("N002").map(|at| at..converted.text.rfind('%').unwrap_or(0)).expect("the arc");
    let both: Vec<usize> =
        converted.map.iter().filter(|(_, text)| *text == arc).map(|(source, _)| source.start).collect();
    assert_eq!(both, [30, 2], "the second block and then the first");
}

#[test]
fn parabolas_are_splines_in_xy_and_chords_elsewhere() {
    let blocks = ["G06X+002000Y+000000I+001000J+001000F100"];
    assert_eq!(body(&format(), &blocks), ["N001 G5.1 X20.00 Y0.00 I10 J10 F100"]);

    let blocks = ["G06X+002000Z+000000I+001000K+001000F100", "M30"];
    let lines = body(&format(), &blocks);
    // By hand: y = x - x²/20 over 20 mm. A chord over h sags h²/160, so 0,0045 mm allow 0,85 mm: 24 chords if all were
    // alike; the curve is longer than its chord, and the chords keep nine tenths of the tolerance of 0,005 mm.
    assert!((24..=40).contains(&(lines.len() - 1)), "{lines:#?}");
    for line in &lines[..lines.len() - 1] {
        let number = |letter: char| line.split(' ').find_map(|word| word.strip_prefix(letter)?.parse::<f64>().ok());
        let (x, z) = (number('X').expect("X"), number('Z').expect("Z"));
        assert!((z - (x - x * x / 20.0)).abs() < 0.001, "{line} is off the parabola");
    }
    assert_eq!(lines[lines.len() - 2], "G1 X20.00 Z0.00");
    assert_eq!(rules(&format(), &blocks), ["CONV-08"]);
    assert!(converted(&format(), &blocks).text.contains("chords, at most 0.005 mm off"));
}

/// By hand: radii of 1,00 and 1,02 differ by 2 increments, which the tape may and LinuxCNC does not take.
#[test]
fn an_arc_that_linuxcnc_refuses_is_chords() {
    let blocks = ["G02X+000102Y+000102I+000100J+000000F100"];
    assert_eq!(rules(&format(), &["G02X+000102Y+000100I+000100J+000000F100"]), [""; 0], "of 1,00 and 1,0002");
    let (lines, rules) = (body(&format(), &blocks), rules(&format(), &blocks));
    assert_eq!(rules, ["CONV-08"], "{lines:?}");
    assert!(lines.iter().all(|line| line.contains("G1 X")) && lines.len() > 5, "{lines:?}");
    assert_eq!(lines.last().map(String::as_str), Some("G1 X1.02 Y1.02"));
}

#[test]
fn feeds_of_every_coding_are_numbers() {
    let run = |change: &dyn Fn(&mut Format), word: &str| {
        let mut format = format();
        change(&mut format);
        body(&format, &["S600M03", &format!("G01X+001000{word}")])[1].clone()
    };
    assert_eq!(run(&|_| {}, "F150"), "N002 G1 X10.00 F150");
    // ISO 2539 A.2.2: 615 is 150, 46 is 0,00046; ISO 1058 A.2.1: 50 is 315.
    assert_eq!(run(&|format| format.itemized.feed = Some(FeedCoding::Arithmetic), "F615"), "N002 G1 X10.00 F150");
    assert_eq!(run(&|format| format.itemized.feed = Some(FeedCoding::Arithmetic), "F046"), "N002 G1 X10.00 F0.00046");
    let geometric = |format: &mut Format| {
        format.detail = format.detail.replace("F3", "F2");
        format.itemized.feed = Some(FeedCoding::Geometric);
    };
    assert_eq!(run(&geometric, "F50"), "N002 G1 X10.00 F315");
    let symbolic = |format: &mut Format| {
        format.detail = format.detail.replace("F3", "F1");
        format.itemized.feed = Some(FeedCoding::Symbolic);
        format.itemized.symbolic_feeds = Some(BTreeMap::from([("3".to_owned(), 240.5)]));
    };
    assert_eq!(run(&symbolic, "F3"), "N002 G1 X10.00 F240.5");
    let reciprocal = |format: &mut Format| format.itemized.feed = Some(FeedCoding::TimeReciprocal);
    assert_eq!(run(&reciprocal, "F012"), "N002 G93 G1 X10.00 F12");
    // RS-274 has a place behind the decimal sign in F.
    let per_revolution = |format: &mut Format| {
        *format = eia_feed();
        format.itemized.feed_unit = Some(FeedUnit::PerRevolution);
    };
    assert_eq!(run(&per_revolution, "F025"), "N002 G95 G1 X10.00 F0.25");
}

/// A.1.2 has F as radians per minute on arcs, annex E as the reciprocal of time. A quarter turn at 2 rad/min takes
/// π/4 minutes.
#[test]
fn a_time_reciprocal_feed_on_an_arc_is_the_reciprocal_of_its_time() {
    let mut format = format();
    format.itemized.feed = Some(FeedCoding::TimeReciprocal);
    let blocks = ["G02X+001000Y+001000I+001000J+000000F002", "G01X+002000F002", "X+003000"];
    for (reading, word) in [(ArcFeed::Radians, "F1.27323954"), (ArcFeed::Time, "F2")] {
        format.itemized.arc_feed = Some(reading);
        let lines = body(&format, &blocks);
        assert_eq!(lines[0], format!("N001 G93 G2 X10.00 Y10.00 I10 J0 {word}"));
        assert_eq!(lines[1..], ["N002 G1 X20.00 F2", "N003 G1 X30.00 F2"], "every block has its own");
    }
}

#[test]
fn another_kind_of_feed_is_said_where_it_changes() {
    let blocks = ["S100M03", "G01X+001000F100", "G93X+002000F010", "G95X+003000F002", "G94X+004000F100", "X+005000"];
    let lines = [
        "N001 S100 M3",
        "N002 G1 X10.00 F100",
        "N003 G93 G1 X20.00 F10",
        "N004 G95 G1 X30.00 F2",
        "N005 G94 G1 X40.00 F100",
        "N006 G1 X50.00",
    ];
    assert_eq!(body(&format(), &blocks), lines);
}

#[test]
fn a_cut_without_a_feed_is_written_so_that_it_stops() {
    let blocks = ["G01X+001000", "X+002000", "X+003000F100"];
    assert_eq!(body(&format(), &blocks), ["N001 G1 X10.00 F0", "N002 G1 X20.00 F0", "N003 G1 X30.00 F100"]);
    assert_eq!(rules(&format(), &blocks), ["CONV-04"]);
}

#[test]
fn spindle_tool_and_coolant() {
    let blocks = ["T05M06", "S600M13", "G00X+001000M05", "S100M04", "M09", "M07M08"];
    let lines = ["N001 T5 M6", "N002 S600 M3 M8", "N003 G0 X10.00", "M5", "N004 S100 M4", "N005 M9", "N006 M7", "M8"];
    assert_eq!(body(&format(), &blocks), lines);

    let mut coded = format();
    coded.itemized.spindle = Some(SpindleCoding::Arithmetic);
    coded.detail = coded.detail.replace("T2", "T4");
    coded.itemized.compensation_digits = Some(2);
    assert_eq!(body(&coded, &["T0512M06", "S615M03", "G96S615", "G97S615"])[..2], ["N001 T5 M6", "N002 S150 M3"]);
    assert_eq!(body(&coded, &["G96S615", "G97S615"]), ["N001 G96 S150", "N002 G97", "S150"]);
}

/// By hand, from the tables of ISO 1056 and of RS274/NGC: what acts after the motion stands behind it.
#[test]
fn miscellaneous_functions_one_by_one() {
    for (block, lines) in [
        ("G00X+001000M00", "N001 G0 X10.00|M5 M9 M0"),
        ("G00X+001000M01", "N001 G0 X10.00|M1"),
        ("G00X+001000M02", "N001 G0 X10.00|M2"),
        ("G00X+001000M30", "N001 G0 X10.00|M30"),
        ("G00X+001000M03", "N001 M3|G0 X10.00"),
        ("G00X+001000M09", "N001 G0 X10.00|M9"),
        ("M48", "N001 M50 P1"),
        ("M49", "N001 M50 P0"),
        ("M60", "N001 M60"),
        ("G00X+001000M19", "(LEFT OUT: M19, Oriented spindle stop)|N001 G0 X10.00|M5"),
        ("M10", "(LEFT OUT: M10, Clamp)|N001"),
        ("M50", "(LEFT OUT: M50, Coolant no. 3 on)|N001"),
        ("M61", "(LEFT OUT: M61, Linear workpiece shift, position 1)|N001"),
        ("M66", "(LEFT OUT: M66)|N001"),
    ] {
        let lines: Vec<&str> = lines.split('|').collect();
        assert_eq!(body(&format(), &[block]), lines, "{block}");
    }
}

/// A number that means something else to LinuxCNC never passes.
#[test]
fn no_function_passes_for_another() {
    // What LinuxCNC is told at all, beside the head.
    let allowed = [
        "G0", "G17", "G18", "G19", "G92", "G92.1", "G97", "M0", "M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8", "M9",
        "M30", "M60",
    ];
    for code in 0..100 {
        for letter in ['G', 'M'] {
            let lines = body(&format(), &[&format!("{letter}{code:02}"), "G00X+001000"]);
            let bare = lines.iter().filter(|line| !line.starts_with('(')).map(|line| line.replace("M50 P", "override"));
            for word in bare.flat_map(|line| line.split(' ').map(str::to_owned).collect::<Vec<_>>()) {
                let passes = allowed.contains(&word.as_str()) || !word.starts_with(['G', 'M']);
                assert!(passes, "{letter}{code:02} gives {word}: {lines:?}");
            }
            let silent = lines.len() == 2 && lines[0] == "N001";
            let nothing_to_do = letter == 'G' && matches!(code, 0..=3 | 6 | 17..=19 | 33..=35 | 40 | 53 | 80 | 90..=97);
            assert!(!silent || nothing_to_do, "{letter}{code:02} is dropped silently");
        }
    }
}

#[test]
fn a_dwell_is_in_seconds() {
    let mut format = eia_feed();
    format.itemized.dwell = Some(Dwell { address: 'F', unit: DwellUnit::Seconds });
    assert_eq!(body(&format, &["G04F150"]), ["N001 G4 P1.5"]);
    format.itemized.dwell = Some(Dwell { address: 'F', unit: DwellUnit::Revolutions });
    assert_eq!(body(&format, &["S120M03", "G04F500"]), ["N001 S120 M3", "N002 G4 P2.5"], "5 turns at 120 a minute");
    format.itemized.dwell = None;
    assert_eq!(body(&format, &["G04F015"]), ["(LEFT OUT: G04, Dwell)", "N001"]);
}

#[test]
fn a_preload_means_the_same_and_is_taken_back_at_the_end() {
    let blocks = ["G00X+001000", "G92X+000000Y+000500", "X+001000", "M30"];
    let lines = ["N001 G0 X10.00", "N002 G92 X0.00 Y5.00", "N003 G0 X10.00", "N004 G92.1", "M30"];
    assert_eq!(body(&format(), &blocks), lines);
}

#[test]
fn a_thread_of_one_lead_is_g33() {
    // By hand: a cone, 10 mm in Z and 2 mm in X; a lead of 1,5 mm along Z is 1,5 · √104 / 10 along the path.
    let blocks = ["S100M03", "G33X+000200Z+001000K+000150", "G34Z+002000K+000150"];
    let lines = body(&format(), &blocks);
    assert_eq!(lines[1], "N002 G33 K1.52970585 X2.00 Z10.00");
    assert_eq!(lines[2..], ["(NOT CONVERTED: N003)", "N003 (ABORT,N003 of the tape is not converted)"]);
    assert_eq!(rules(&format(), &blocks), ["CONV-01"]);
}

/// By hand: y = x³ through (1, 1), (2, 8) and (3, 27), in chords whose ends lie on it to the places that are written.
#[test]
fn a_cubic_is_chords() {
    let mut cubic = format();
    cubic.itemized.curves = Some([("G05".to_owned(), CurveKind::Cubic)].into());
    let blocks = ["G05X+000100Y+000100F100", "X+000200Y+000800", "X+000300Y+002700", "G01X+000400"];
    assert_eq!(rules(&cubic, &blocks), ["CONV-08"]);
    let lines = body(&cubic, &blocks);
    let number = |line: &str, letter: char| -> Option<f64> {
        line.split(' ').find_map(|word| word.strip_prefix(letter)?.parse().ok())
    };
    let points: Vec<(f64, f64)> = lines.iter().filter_map(|line| number(line, 'X').zip(number(line, 'Y'))).collect();
    assert!(points.len() > 8 && points.contains(&(3.0, 27.0)), "{lines:?}");
    for (x, y) in points {
        // Half of a ten-thousandth in x counts by the slope, 27 at most.
        assert!((x * x * x - y).abs() < 28.0 * 0.000_05, "{x} {y}");
    }
    assert_eq!(lines.last().map(String::as_str), Some("N004 G1 X4.00"));
}

/// Metres per minute under G21. D, the greatest speed, may be left out in LinuxCNC.
#[test]
fn a_cutting_speed_is_g96() {
    let lines = body(&format(), &["G96", "S200M03", "G97", "S500", "M30"]);
    assert_eq!(lines, ["N001", "N002 G96 S200 M3", "N003 G97", "N004 S500", "N005 M30"]);
}

#[test]
fn rotary_axes_are_in_degrees() {
    for (classification, angle) in [("CAMR333", "B180.000"), ("CAMD333", "B0.500")] {
        let format = Format::new(Standard::Iso2539, "N3G2X+42B+33F3M2*").classified(classification);
        assert_eq!(body(&format, &["G00X+001000B+000500"]), [format!("N001 G0 X10.00 {angle}")]);
    }
    let mut reciprocal = Format::new(Standard::Iso2539, "N3G2X+42B+33F3M2*").classified("CAMD333");
    reciprocal.itemized.feed = Some(FeedCoding::TimeReciprocal);
    assert_eq!(body(&reciprocal, &["G01B+090000F002"]), ["N001 G93 G1 B90.000 F2"]);
}

#[test]
fn words_that_linuxcnc_lacks_are_left_out_and_said() {
    let format = Format::new(Standard::Iso2539, "N3G2X+42B1P+42F3M2*").classified("CAM333");
    let lines = body(&format, &["G00X+001000B5", "P+000100", "G01X+002000B6F100"]);
    let left = ["(LEFT OUT: B5)", "N001 G0 X10.00", "(LEFT OUT: P+000100)", "N002"];
    assert_eq!(lines[..4], left);
    let found = converted(&format, &["G00X+001000B5", "P+000100", "G01X+002000B6F100"]).diagnostics;
    let found: Vec<_> = found.iter().map(|found| (found.id, found.count)).collect();
    assert_eq!(found, [("CONV-03", 2), ("CONV-03", 1)]);
}

#[test]
fn comments_and_program_numbers_are_carried() {
    let mut format = format();
    format.itemized.program_number_digits = Some(3);
    let text =
        to_decimal("(LEADER)%123\nN001G00X+001000(FIRST\nHOLE)(MSG,GO)\nN002M30\n", &format, Dialect::LinuxCnc).text;
    let body = "(Program 123)\n(LEADER)\n(FIRST HOLE)\n(tape: MSG,GO)\nN001 G0 X10.00\nN002 M30\n%\n";
    assert!(text.ends_with(body), "{text}");
}

/// All that a line says is said again behind one that may be skipped.
#[test]
fn blocks_that_may_be_skipped_stay_so() {
    let blocks = ["G01X+001000F100", "/X+002000F200", "X+003000Y+000000F200"];
    let lines = ["N001 G1 X10.00 F100", "/N002 G94 G1 X20.00 F200", "N003 G94 G1 X30.00 Y0.00 F200"];
    assert_eq!(body(&format(), &blocks), lines);
    assert_eq!(rules(&format(), &blocks), [""; 0], "the next block gives all again");
    assert_eq!(rules(&format(), &["G01X+001000F100", "/X+002000", "Y+001000"]), ["CONV-05"]);
    assert_eq!(body(&format(), &["/M05M30"]), ["/N001 M5", "/M30"]);
}

#[test]
fn what_the_tape_does_not_say_is_not_written() {
    let blocks = ["G01X+001000F100", "G02X+002000Y+000000I+000100J+000000", "G01Y+001000"];
    let converted = converted(&format(), &blocks);
    assert!(converted.text.contains("(INCOMPLETE: a motion is not converted."), "{}", converted.text);
    let lines = body(&format(), &blocks);
    let wanted = [
        "N001 G1 X10.00 F100",
        "(NOT CONVERTED: N002)",
        "N002 (ABORT,N002 of the tape is not converted)",
        "N003 G1 Y10.00",
    ];
    assert_eq!(lines, wanted);
    let found = &converted.diagnostics[0];
    assert_eq!((found.id, converted.diagnostics.len()), ("CONV-01", 1));
}

#[test]
fn programs_behind_the_first_are_reached() {
    let text = to_decimal(
        "%1\nN001G00X+001000\nN002M30\n%2\nN001G00X+002000\nN002M30\nN003X+000000\n",
        &format(),
        Dialect::LinuxCnc,
    );
    let body = "N002 M5 M9 M0\n(Program 2)\nN001 G0 X20.00\nN002 M30\n%\n";
    assert!(text.text.ends_with(body), "{}", text.text);
    let found: Vec<_> = text.diagnostics.iter().map(|found| found.id).collect();
    assert_eq!(found, ["CONV-06", "CONV-07"]);
}

/// Read back as decimal numbers, the coordinates are those of the spans, to the bit.
#[test]
fn coordinates_read_back_are_the_ends_of_the_spans() {
    let random = (1000..1200).map(random_tape).map(|tape| (tape.format, tape.source));
    let presets = presets::tapes().into_iter().map(|preset| (preset.format, preset.source.to_owned()));
    for (format, source) in presets.chain(random) {
        let tape = Tape::new(&source, &format);
        let converted = to_decimal(&source, &format, Dialect::LinuxCnc);
        let spans = &tape.spans().list;
        let mut at = spans[0].start;
        let mut ends = converted.text.lines().map(|line| {
            let words = line.trim_start_matches('/').split(' ');
            if !line.starts_with('(') {
                for word in words {
                    let axis = "XYZ".find(word.chars().next().unwrap_or(' '));
                    if let (Some(axis), Ok(value)) = (axis, word.get(1..).unwrap_or("").parse::<f64>()) {
                        at[axis] = value;
                    }
                }
            }
            at
        });
        for span in spans {
            assert!(ends.any(|end| end == span.end), "{span:?}\n{source}\n{}", converted.text);
        }
    }
}
