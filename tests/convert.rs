//! Tapes as tapes of other formats: one example worked by hand for each thing that a format decides, and random tapes
//! there and back, whose truth is the curve that they were made of.

#[path = "support/random_tape.rs"]
mod random_tape;

use nctape::convert::{Converted, convert};
use nctape::format::{
    ArcCentre, ArcFeed, ArcParameters, CurveKind, Declared, Dimensions, Dwell, DwellUnit, FeedCoding, FeedUnit, Format,
    Itemized, ParabolaParameters, Plane, Standard, TimeScale,
};
use nctape::span::{Geometry, Span, SpanKind};
use nctape::{Severity, Tape, presets};
use random_tape::random_tape;

fn format() -> Format {
    let mut format = Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42I+42J+42K+42F4S4T2M2*").classified("CAM 333");
    format.itemized.arc_centre = Some(ArcCentre::FromStart);
    format.itemized.full_circle = Some(true);
    format
}

fn numbered(blocks: &[&str]) -> String {
    let numbered = blocks.iter().enumerate().map(|(index, block)| match block.strip_prefix('/') {
        Some(block) => format!("/N{:03}{block}\n", index + 1),
        None => format!("N{:03}{block}\n", index + 1),
    });
    format!("%\n{}", numbered.collect::<String>())
}

fn converted(from: &Format, to: &Format, blocks: &[&str]) -> Converted {
    convert(&numbered(blocks), from, to)
}

/// The blocks of the other tape, about which there is nothing to say.
fn written(from: &Format, to: &Format, blocks: &[&str]) -> Vec<String> {
    let converted = converted(from, to, blocks);
    let said: Vec<&str> = converted.diagnostics.iter().map(|found| found.message.as_str()).collect();
    assert!(said.is_empty(), "{said:?}\n{}", converted.text);
    sound(&converted, to);
    converted.text.lines().skip(1).map(str::to_owned).collect()
}

/// A tape has nothing wrong with it.
fn sound(converted: &Converted, format: &Format) {
    let tape = Tape::new(&converted.text, format);
    let found = tape.diagnostics().into_iter().filter(|found| found.severity > Severity::Info && found.id != "TAPE-10");
    let found: Vec<String> = found.map(|found| format!("{} {}", found.id, found.message)).collect();
    assert!(found.is_empty(), "{found:?}\n{}", converted.text);
}

fn rules(converted: &Converted) -> Vec<&'static str> {
    converted.diagnostics.iter().map(|found| found.id).collect()
}

#[test]
fn a_tape_of_the_same_format_keeps_its_blocks() {
    let blocks = [
        "T03 M06",
        "S0600 M03",
        "G00 X+001000 Y+002000 M08",
        "G01 Z-000500 F0100",
        "G03 X+000000 Y+001000 I-001000 J+000000",
        "G06 X+003000 Y+000000 I+001000 J+001000",
        "X+004000 (LAST) M09",
        "M30",
    ];
    let wanted = [
        "N001 T03 M06",
        "N002 S0600 M03",
        "N003 G00 X+001000 Y+002000 M08",
        "N004 G01 Z-000500 F0100",
        "N005 G03 X+000000 Y+001000 I-001000 J+000000",
        "N006 G06 X+003000 Y+000000 I+001000 J+001000",
    ];
    let blocks = written(&format(), &format(), &blocks[..6]);
    assert_eq!(blocks, wanted);
}

/// By hand: 25,4 mm are an inch, 254 mm/min are 10 inch/min; a quarter of a turn is 90 degrees.
#[test]
fn units_and_places_are_those_of_the_other_format() {
    let from = Format::new(Standard::Iso2539, "N3G2X+42Y+42B+32F4M2*").classified("CAMD 333");
    let mut to = Format::new(Standard::Iso2539, "N4.G2.XL24.YL24.BL14.F3.M2*").classified("CSIR 333");
    to.itemized.dimensions = Some(Dimensions::Incremental);
    to.itemized.feed = Some(FeedCoding::Arithmetic);
    let blocks = ["G00 X+002540 Y+005080", "G01 X+005080 F0254", "B+09000 F0360", "M30"];
    let wanted = [
        "N0001\tG00\tX+010000\tY+020000",
        "N0002\tG01\tX+010000\t\t\tF510",
        // 360 degrees a minute are one turn: code 410.
        "N0003\t\t\t\tB+02500\tF410",
        "N0004\t\t\t\t\t\tM30",
    ];
    assert_eq!(written(&from, &to, &blocks), wanted);
}

#[test]
fn the_reading_of_a_centre_is_that_of_the_other_format() {
    for (reading, words) in [
        (ArcCentre::FromStart, "I-001000 J+000000"),
        (ArcCentre::ToStart, "I+001000 J+000000"),
        (ArcCentre::Absolute, "I+000000 J+000000"),
        (ArcCentre::AsDimensions, "I+000000 J+000000"),
        (ArcCentre::Quadrant, "I+001000 J+000000"),
    ] {
        let mut to = format();
        to.itemized.arc_centre = Some(reading);
        let blocks = ["G00 X+001000", "G03 X+000000 Y+001000 I-001000 J+000000 F0100"];
        let arc = format!("N002 G03 X+000000 Y+001000 {words} F0100");
        assert_eq!(written(&format(), &to, &blocks)[1], arc, "{reading:?}");
    }
}

/// By hand: the radius is 10 mm, a quarter circle 15,708 mm long; 100 mm/min are 10 radians a minute, and 6,366 quarters.
#[test]
fn feeds_are_said_by_the_coding_of_the_other_format() {
    let blocks = ["G00 X+001000", "G03 X+000000 Y+001000 I-001000 J+000000 F0100", "G01 X-001000 Y+001000"];
    let reciprocal = |arc_feed: ArcFeed| {
        let mut to = format();
        to.itemized.feed = Some(FeedCoding::TimeReciprocal);
        (to.itemized.arc_feed, to.itemized.time_scale) = (Some(arc_feed), Some(TimeScale(10)));
        converted(&format(), &to, &blocks)
    };
    let radians = reciprocal(ArcFeed::Radians);
    assert!(radians.text.contains("J+000000 F0100\nN003 G01 X-001000 Y+001000 F0100\n"), "{}", radians.text);
    let time = reciprocal(ArcFeed::Time);
    assert!(time.text.contains("J+000000 F0063\nN003 G01 X-001000 Y+001000 F0100\n"), "{}", time.text);
    // 63 is a hundredth off 63,66, and that is said; 100 is exact.
    assert_eq!(rules(&time), ["CONV-10"]);
    let mut geometric = format();
    geometric.detail = geometric.detail.replace("F4", "F2");
    geometric.itemized.feed = Some(FeedCoding::Geometric);
    let arc = &written(&format(), &geometric, &blocks)[1];
    assert_eq!(arc, "N002 G03 X+000000 Y+001000 I-001000 J+000000 F40");
    // And back: 40 is 100 mm/min.
    let back = ["G00 X+001000", "G01 X+000000 F40", "X+001000 F99"];
    assert_eq!(written(&geometric, &format(), &back[..2])[1], "N002 G01 X+000000 F0100");
    assert_eq!(written(&geometric, &geometric, &back)[2], "N003 X+001000 F99");
}

/// Under G95 and G97 with 500 revolutions a minute, 0,2 mm each are 100 mm/min; without a speed the other tape says G95.
#[test]
fn a_feed_per_revolution_is_kept_or_turned() {
    let from = Format { detail: "N3G2X+42Y+42F12S4M2*".to_owned(), ..Format::new(Standard::Rs274, "") };
    let mut to = Format::new(Standard::Rs274, "n3 g2 x+42 y+42 f32 s4 m2*");
    assert_eq!(
        written(&from, &to, &["S0500 M03", "G95 G01 X+001000 F020"]),
        ["n001 s0500 m03", "n002 g01 x+001000 f10000"]
    );
    let unknown = converted(&from, &to, &["G95 G01 X+001000 F020", "G94 X+002000 F020"]);
    assert_eq!(unknown.text, "%\nn001 g95\nn002 g01 x+001000 f00020\nn003 g94\nn004 x+002000 f00020\n");
    to.itemized.feed_unit = Some(FeedUnit::PerRevolution);
    assert_eq!(written(&from, &to, &["G95 G01 X+001000 F020"]), ["n001 g01 x+001000 f00020"]);
}

#[test]
fn threads_dwells_and_vectors_go_over() {
    let mut from = format();
    from.itemized.dwell = Some(Dwell { address: 'X', unit: DwellUnit::Seconds });
    let mut to = Format::new(Standard::Iso2539, "N3G2XL43YL43ZL43I33J33K33F4S4T2M2*").classified("CAM 333");
    to.itemized.dwell = Some(Dwell { address: 'F', unit: DwellUnit::Revolutions });
    let blocks = ["S0600 M03", "G33 Z-001000 K+000150", "G04 X+000200", "M30"];
    let wanted = ["N001 S0600 M03", "N002 G33 Z-0010000 K001500", "N003 G04 F0020", "N004 M30"];
    assert_eq!(written(&from, &to, &blocks), wanted);

    let vectors = |places: &str| {
        let mut format = Format::new(Standard::Iso2539, &format!("N3G2X+42Y+42P+{places}Q+{places}F4M2*"));
        format.classification = Some("CAM 222".to_owned());
        format.itemized.compensation = Some(true);
        format
    };
    let blocks = ["G01 G41 X+001000 P+00000 Q+10000 F0100", "G40", "G09 X+002000"];
    let text = converted(&vectors("14"), &vectors("12"), &blocks).text;
    assert_eq!(text, "%\nN001 G41\nN002 G01 X+001000 P+000 Q+100 F0100\nN003 G40\nN004 G09 X+002000\n");
}

/// By hand: the cubic y = x³ from 0 to 3 with z in proportion, points at x = 1 and x = 2.
#[test]
fn a_cubic_is_three_points_or_chords() {
    let cubic = |code: &str| {
        let mut format = format();
        format.itemized.curves = Some([(code.to_owned(), CurveKind::Cubic)].into());
        format
    };
    let blocks = ["G05 X+000100 Y+000100 F0100", "X+000200 Y+000800", "X+000300 Y+002700"];
    let points = ["N001 G07 X+000100 Y+000100 F0100", "N002 X+000200 Y+000800", "N003 X+000300 Y+002700"];
    assert_eq!(written(&cubic("G05"), &cubic("G07"), &blocks), points);
    let chords = converted(&cubic("G05"), &format(), &blocks);
    assert_eq!(rules(&chords), ["CONV-08"]);
    let tape = Tape::new(&chords.text, &format());
    assert!(tape.spans().list.len() > 10);
    for span in &tape.spans().list {
        // Half an increment from the tolerance, and half of one along each axis from rounding, over the slope of 27.
        let [x, y, _] = span.end;
        assert!((x * x * x - y).abs() < 0.012 * 27.0, "{span:?}");
    }
}

/// A helix on a control without: chords, the third axis with them.
#[test]
fn a_helix_is_chords_where_there_is_none() {
    let mut to = format();
    to.itemized.helix = Some(false);
    let blocks = ["G00 X+001000", "G03 X+000000 Y+001000 Z+001000 I-001000 J+000000 F0100"];
    let chords = converted(&format(), &to, &blocks);
    assert_eq!(rules(&chords), ["CONV-08"]);
    sound(&chords, &to);
    for span in &Tape::new(&chords.text, &to).spans().list {
        let [x, y, z] = span.end;
        assert!((libm::hypot(x, y) - 10.0).abs() < 0.01, "{span:?}");
        // A degree of the quarter is a ninth of a millimetre.
        assert!((libm::atan2(y, x).to_degrees() / 9.0 - z).abs() < 0.02, "{span:?}");
    }
}

#[test]
fn what_the_other_format_lacks_stops_its_tape() {
    let bare = Format::new(Standard::Iso2539, "N3G2X+32Y+42F4M2*").classified("CAM 222");
    let positioning = Format::new(Standard::Iso1058, "N3G2X+42Y+42Z+42F2S2T2M2*").classified("PAM 332");
    for (to, block, at, rule) in [
        (&bare, "G00 X+100000", "G00 X+100000", "CONV-09"),
        (&bare, "G00 Z+001000", "G00 Z+001000", "CONV-09"),
        (&bare, "T03", "T03", "CONV-09"),
        (&positioning, "G02 X+001000 I+000500 J+000000 F0100", "G02 X+001000 I+000500 J+000000 F0100", "CONV-09"),
        (&bare, "G02 X+001000 I+000700 J+000000 F0100", "G02 X+001000 I+000700 J+000000 F0100", "CONV-01"),
    ] {
        let source = numbered(&[block]);
        let converted = convert(&source, &format(), to);
        assert!(converted.text.ends_with("M00 (NOT CONVERTED)\n"), "{block}: {}", converted.text);
        let worst = converted.diagnostics.iter().find(|found| found.severity == Severity::Error).expect("an error");
        let (range, start) = (worst.range.clone(), source.find(at).expect("the words"));
        assert!(range.start <= start && range.end == start + at.len(), "{:?}", &source[range]);
        assert_eq!(worst.id, rule, "{block}");
    }
    let unfed = converted(&format(), &format(), &["G01 X+001000", "X+002000", "Y+001000 F0100"]);
    assert_eq!(rules(&unfed), ["CONV-04"]);
    assert_eq!(unfed.diagnostics[0].count, 2);
    assert_eq!(unfed.text, "%\nN001 M00 (NO FEED)\nN002 G01 X+001000\nN003 X+002000\nN004 Y+001000 F0100\n");
}

#[test]
fn functions_mean_what_iso_1056_says_or_both_builders() {
    let declares = |meaning: &str| {
        let mut format = format();
        let m = [("M52".to_owned(), meaning.to_owned())].into();
        format.itemized.declared = Some(Declared { m, ..Declared::default() });
        format
    };
    let blocks = ["M52", "M11", "G60", "G08", "G00 X+001000 M09", "M30"];
    let all = ["N001 M52", "N002 M11", "N003 G60", "N004 G08", "N005 G00 X+001000 M09", "N006 M30"];
    assert_eq!(written(&declares("CHUTE"), &declares("CHUTE"), &blocks), all);
    let other = converted(&declares("CHUTE"), &declares("DOOR"), &blocks);
    assert_eq!(rules(&other), ["CONV-02"]);
    assert!(other.text.starts_with("%\nN001 M11 (LEFT OUT M52)\nN002 G60\n"), "{}", other.text);
    // Two digits of the compensation on one side, one on the other.
    let mut from = Format { detail: format().detail.replace("T2", "T4"), ..format() };
    from.itemized.compensation_digits = Some(2);
    let mut to = Format { detail: format().detail.replace("T2", "T3"), ..format() };
    to.itemized.compensation_digits = Some(1);
    assert_eq!(written(&from, &to, &["T0305 M06"]), ["N001 T035 M06"]);
    assert_eq!(rules(&converted(&from, &to, &["T0312 M06"])), ["CONV-03"]);
}

#[test]
fn skip_alignment_comments_and_programs_go_over() {
    let mut numbered = format();
    numbered.itemized.program_number_digits = Some(3);
    let source = "(HEAD)\n%0012\nN001 G00 X+001000 (GO)\n/N002 X+002000\n:003 G00 X+003000\nN004 M30\n%7 (TWO)\nN005 G00 \
                  X+000000\nN006 M30 (DONE)\n";
    let mut from = format();
    from.itemized.program_number_digits = Some(4);
    let converted = convert(source, &from, &numbered);
    let wanted = "%012\nN001 G00 X+001000 (HEAD) (GO)\n/N002 G00 X+002000\n:003 G00 X+003000\nN004 M30\n%007\nN005 G00 \
                  X+000000 (TWO)\nN006 M30 (DONE)\n";
    assert_eq!(converted.text, wanted);
    assert_eq!(rules(&converted), [""; 0]);
    // Where the other format is incremental, a block that is skipped moves all behind it.
    numbered.detail = numbered.detail.replace("X+42", "XD42");
    assert_eq!(rules(&convert(source, &from, &numbered)), ["CONV-05"]);
    numbered.itemized.program_number_digits = None;
    assert_eq!(rules(&convert(source, &from, &numbered)), ["CONV-03", "CONV-05"]);
}

#[test]
fn sequence_numbers_that_begin_anew_are_said() {
    let source: String = (0..1001).map(|number| format!("G00 X{}\n", number % 7)).collect();
    let converted = nctape::convert::from_decimal(&source, &format());
    assert_eq!(rules(&converted), ["CONV-09"]);
    assert_eq!(converted.diagnostics[0].severity, Severity::Warning);
    assert_eq!(source[..converted.diagnostics[0].range.start].lines().count(), 999);
}

/// Presets in their own format are what they were.
#[test]
fn presets_keep_their_path_in_their_own_format() {
    for preset in presets::tapes().iter().filter(|preset| preset.format.standard != Standard::Iso1058) {
        let one = Tape::new(preset.source, &preset.format);
        let two = Tape::new(&convert(preset.source, &preset.format, &preset.format).text, &preset.format);
        let course = |tape: &Tape| -> Vec<_> {
            let sound = tape.spans().list.iter().filter(|span| !span.substitute);
            sound.map(|span| (span.kind, span.start, span.end, span.geometry)).collect()
        };
        assert_eq!(course(&one), course(&two), "{}", preset.id);
        let (one, two) = (one.totals().seconds, two.totals().seconds);
        assert!(one.zip(two).is_none_or(|(one, two)| (one - two).abs() < 1e-6 * one), "{}", preset.id);
    }
}

/// Another format in the same unit, with so many places.
fn other(number: u64, from: &Format, places: usize) -> Format {
    let one_of = |salt: u64, count: u64| (number / salt % count) as usize;
    let inch = from.standard == Standard::Rs274 || from.classification.as_deref() == Some("CSI 333");
    let tabs = number.is_multiple_of(3);
    let lengths: String =
        "XYZIJK".chars().map(|letter| format!("{}{letter}L4{places}", if tabs { "." } else { "" })).collect();
    let class = format!("C{}{} 333", if tabs { 'S' } else { 'A' }, if inch { 'I' } else { 'M' });
    let reading = if number.is_multiple_of(7) {
        ArcCentre::Quadrant
    } else {
        [ArcCentre::AsDimensions, ArcCentre::FromStart, ArcCentre::ToStart, ArcCentre::Absolute][one_of(2, 4)]
    };
    Format {
        itemized: Itemized {
            set_point: from.itemized.set_point.clone(),
            dimensions: Some([Dimensions::Absolute, Dimensions::Incremental][one_of(1, 2)]),
            plane: Some([Plane::Xy, Plane::Zx, Plane::Yz][one_of(1, 3)]),
            arc_parameters: number.is_multiple_of(11).then_some(ArcParameters::AngleRadius),
            arc_centre: Some(reading),
            parabola_parameters: Some(
                [ParabolaParameters::Tangent, ParabolaParameters::Slope, ParabolaParameters::Focus][one_of(5, 3)],
            ),
            helix: Some(!number.is_multiple_of(5)),
            full_circle: Some(!number.is_multiple_of(4)),
            feed: Some(FeedCoding::Arithmetic),
            rapid: from.itemized.rapid,
            ..Itemized::default()
        },
        ..Format::new(Standard::Iso2539, &format!("N6G2{lengths}F5S4T2M2*")).classified(&class)
    }
}

/// How far a point is from the curve of a span: from the line through its ends, from its circle, from the point of its
/// parabola whose parameter is that of the point.
fn distance(span: &Span, at: [f64; 3]) -> f64 {
    let minus = |one: [f64; 3], two: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| one[axis] - two[axis]) };
    let dot = |one: [f64; 3], two: [f64; 3]| -> f64 { (0..3).map(|axis| one[axis] * two[axis]).sum() };
    let norm = |it: [f64; 3]| dot(it, it).sqrt();
    match span.geometry {
        Geometry::Line => {
            let (way, off) = (minus(span.end, span.start), minus(at, span.start));
            let share = (dot(way, off) / dot(way, way)).clamp(0.0, 1.0);
            norm(minus(off, way.map(|part| part * share)))
        }
        Geometry::Arc(arc) => {
            let [first, second, third] = arc.plane.axes();
            let radius = libm::hypot(at[first] - arc.centre[0], at[second] - arc.centre[1]);
            let (low, high) = (span.start[third].min(span.end[third]), span.start[third].max(span.end[third]));
            let beside = (low - at[third]).max(at[third] - high).max(0.0);
            let (least, most) = (arc.start_radius.min(arc.end_radius), arc.start_radius.max(arc.end_radius));
            // Its ends are not equally far from its centre: what is as near to it as they are apart is on it.
            let slack = (most - least) / 2.0;
            (least - slack - radius).max(radius - most - slack).max(0.0).max(beside)
        }
        Geometry::Parabola { tangent } => {
            // P = P0 + u (PT - P0) + v (P2 - P0) with u = 2t(1 - t) and v = t², so that t = u/2 + v.
            let (a, b, off) = (minus(tangent, span.start), minus(span.end, span.start), minus(at, span.start));
            let (aa, ab, bb, ao, bo) = (dot(a, a), dot(a, b), dot(b, b), dot(a, off), dot(b, off));
            let (u, v) = ((ao * bb - bo * ab) / (aa * bb - ab * ab), (bo * aa - ao * ab) / (aa * bb - ab * ab));
            let off_at = |t: f64| {
                let on = std::array::from_fn(|axis| 2.0 * t * (1.0 - t) * a[axis] + t * t * b[axis]);
                norm(minus(off, on))
            };
            // The nearest point of it is not far from that one.
            let (mut t, mut step) = (u / 2.0 + v, 0.01);
            while step > 1e-9 {
                match [t - step, t + step].into_iter().find(|&other| off_at(other) < off_at(t)) {
                    Some(nearer) => t = nearer,
                    None => step /= 2.0,
                }
            }
            off_at(t)
        }
        Geometry::Curve { .. } => panic!("no random tape has a cubic"),
    }
}

/// Every span of a tape is one or more of the other, which end where it ends and keep to its curve.
fn same_path(one: &Tape, two: &Tape, ends: f64, off: f64, feeds: Option<f64>, told: &str) {
    let mut others = 0..two.spans().list.len();
    for span in &one.spans().list {
        loop {
            let index = others.next().unwrap_or_else(|| panic!("{span:?} is lost\n{told}"));
            let other = &two.spans().list[index];
            assert!(!other.substitute, "{other:?} for {span:?}\n{told}");
            assert_eq!(span.kind == SpanKind::Rapid, other.kind == SpanKind::Rapid, "{span:?} {other:?}");
            let mut farthest: f64 = 0.0;
            nctape::flatten::flatten_span(other, off / 10.0, &mut |at| farthest = farthest.max(distance(span, at)));
            assert!(farthest <= off, "{farthest} of {other:?} for {span:?}\n{told}");
            if let (Some(feed), Some(other), SpanKind::Line, Some(share)) = (span.feed, other.feed, span.kind, feeds) {
                assert!((feed / other - 1.0).abs() < share, "{feed} {other}\n{told}");
            }
            if (0..3).all(|axis| (span.end[axis] - other.end[axis]).abs() <= ends) && reaches(span, other) {
                break;
            }
        }
    }
    assert!(others.next().is_none(), "more spans\n{told}");
}

/// A span that ends where another ends is its last piece: a first piece of a full circle may end near its start.
fn reaches(span: &Span, piece: &Span) -> bool {
    let way = |span: &Span| if let Geometry::Arc(arc) = span.geometry { arc.sweep.abs() } else { 0.0 };
    span.start != span.end || way(piece) > 0.0 && span.end == piece.end || piece.start != span.start
}

#[test]
fn random_tapes_keep_their_path_there_and_back() {
    let (mut curves, mut compared) = (0, 0);
    for number in 3000..3300 {
        let tape = random_tape(number);
        let places = if tape.format.detail.contains("52") {
            2
        } else if tape.format.detail.contains("34") {
            4
        } else {
            3
        };
        let there = (places + number as usize % 3).clamp(3, 5) - 1;
        let to = other(number, &tape.format, there);
        let converted = convert(&tape.source, &tape.format, &to);
        let errors = converted.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        let errors: Vec<&str> = errors.map(|found| found.message.as_str()).collect();
        // A feed beyond the greatest code, which a random F per revolution may be; a curve that turns within it.
        if errors.iter().any(|message| message.contains("has no code in F: the greatest")) {
            continue;
        }
        assert!(errors.is_empty(), "{number}: {errors:?}\n{}\n{}", tape.source, converted.text);
        let (one, two) = (Tape::new(&tape.source, &tape.format), Tape::new(&converted.text, &to));
        let step = |places: usize| libm::pow(10.0, -(places as f64));
        let told = format!("{number} {:?}\n{}\n{to:?}\n{}", tape.format, tape.source, converted.text);
        let ends = if there < places { 0.51 * step(there) } else { 1e-9 };
        // Ends and centre are each off by half an increment along both axes: √½ each, the curve by both at most.
        let off = 2.0 * 0.5_f64.sqrt() * step(there) + 1e-9;
        // Four digits of the code.
        same_path(&one, &two, ends, off, Some(1e-3), &told);
        compared += 1;
        curves += one.spans().list.iter().filter(|span| span.geometry != Geometry::Line).count();
        if there < places {
            continue;
        }
        let back = convert(&converted.text, &to, &tape.format);
        let three = Tape::new(&back.text, &tape.format);
        let told = format!("{number} back\n{}\n{}\n{}", tape.source, converted.text, back.text);
        let errors = back.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        // The reciprocal of the time of a piece may be beyond F.
        if errors.clone().any(|found| found.message.contains("has no code in F")) {
            continue;
        }
        assert_eq!(errors.count(), 0, "{:?}\n{told}", back.diagnostics);
        same_path(&one, &three, 1e-9, 2.0 * off + 2.0 * 0.5_f64.sqrt() * step(places), None, &told);
    }
    assert!(compared > 150 && curves > 1500, "{compared} {curves}");
}
