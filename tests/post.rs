//! The post-processor: CLDATA becomes tapes that do what it says.

use nctape::convert::Converted;
use nctape::post::{Arcs, Options, postprocess, postprocess_with};
use nctape::span::SpanKind;
use nctape::{Format, Severity, Standard, Tape, presets};
use std::path::Path;

/// The annex E contour: start (10, 10, 20), and its points as the departures of the printed tape add up to them.
const ANNEX_E: &str = include_str!("cldata/annex_e.cld");

/// The format and the text of a preset.
fn preset(id: &str) -> (Format, &'static str) {
    let preset = presets::all().into_iter().find(|preset| preset.id == id).expect("the preset");
    (preset.format, preset.source)
}

/// Three axes with three places, wide enough for anything here.
fn wide() -> Format {
    Format::new(Standard::Iso2539, "N4G2X+53Y+53Z+53I+53J+53K+53F5S5T2M2*").classified("CAM 333")
}

/// A text of some records: their elements behind the number, with an end.
fn records(records: &[&str]) -> String {
    let end = ["20000,0,END", "14000"];
    let all = ["9000,9,1"].iter().chain(records).chain(&end).enumerate();
    all.map(|(index, record)| format!("{},{record};\n", index + 1)).collect::<String>() + ":\n"
}

/// The blocks between the program start and the end of program, without their sequence numbers.
fn blocks(posted: &Converted) -> Vec<&str> {
    let lines: Vec<&str> = posted.text.lines().collect();
    lines[1..lines.len() - 1].iter().map(|line| line.split_once(' ').map_or(*line, |(_, words)| words)).collect()
}

fn found(posted: &Converted) -> Vec<&'static str> {
    posted.diagnostics.iter().map(|found| found.id).collect()
}

fn weighty(found: &[nctape::Diagnostic]) -> Vec<String> {
    let weighs = found.iter().filter(|found| found.severity > Severity::Info);
    weighs.map(|found| format!("{}: {}", found.id, found.message)).collect()
}

/// The words of each block that have one of these addresses, as they stand.
fn words<'a>(text: &'a str, letters: &str) -> Vec<Vec<&'a str>> {
    let of = |line: &'a str| line.split(['\t', ' ']).filter(|word| word.starts_with(|c| letters.contains(c))).collect();
    text.lines().filter(|line| line.starts_with('N')).map(of).collect()
}

/// ISO 2539 annex E prints the tape; facts on its N007: I there is a minus zero.
#[test]
fn the_circular_contour_of_annex_e_word_for_word() {
    let (format, printed) = preset("annex-e-circular");
    let posted = postprocess_with(ANNEX_E, &format, &Options { quadrants: true, ..Options::default() });
    assert_eq!(found(&posted), [""; 0]);
    let printed = printed.replace("I-000000", "I+000000");
    // N001 of the printed tape turns the spindle off and says G01.
    let wanted: Vec<_> = words(&printed, "XYZIJF").into_iter().skip(1).collect();
    let all = words(&posted.text, "XYZIJF");
    assert_eq!(wanted.len(), 11);
    assert_eq!(all[..11], wanted);
    assert_eq!((all[11].len(), words(&posted.text, "M")[11].clone()), (0, vec!["M30"]));
    let tape = Tape::new(&posted.text, &format);
    assert_eq!(weighty(&tape.diagnostics()), [""; 0]);
}

/// The parabolic tape of annex E takes three spans for the first circle and two for the second, within 0,01.
#[test]
fn the_circles_of_annex_e_as_parabolas() {
    let (format, printed) = preset("annex-e-parabolic");
    let options = Options { arcs: Some(Arcs::Parabolas), tolerance: Some(0.01), ..Options::default() };
    let posted = postprocess_with(ANNEX_E, &format, &options);
    assert_eq!(found(&posted), [""; 0]);
    let spans = |text: &str| -> Vec<_> {
        let tape = Tape::new(text, &format);
        tape.spans().list.iter().filter(|span| span.kind == SpanKind::Parabola).cloned().collect()
    };
    let (own, others) = (spans(&posted.text), spans(printed));
    assert_eq!((own.len(), others.len()), (5, 5));
    for (own, other) in own.iter().zip(&others) {
        // The printed points are truncated, and the author's second centre is off by 0,005 in both axes.
        let off = (0..2).map(|axis| (own.end[axis] - other.end[axis]).abs()).fold(0.0, f64::max);
        assert!(off <= 0.0061, "{own:?} {other:?}");
    }
}

#[test]
fn files_of_a_cam_system() {
    for (file, motions) in [("bohren_1.cld", 26), ("profilfraesen_2.cld", 52), ("bohren_1.ncl", 26)] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cldata/creopost");
        let text = std::fs::read_to_string(folder.join(file)).unwrap();
        let posted = postprocess(&text, &wide());
        // Two holes of four strokes each: one move over each, one down to its clearance the first time, three for each
        // stroke but the last, which takes two; and the way in and out.
        assert!(found(&posted).iter().all(|id| *id == "CONV-10"), "{file}: {:?}", posted.diagnostics);
        let tape = Tape::new(&posted.text, &wide());
        assert_eq!(weighty(&tape.diagnostics()), [""; 0], "{file}");
        assert_eq!(tape.spans().list.len(), motions, "{file}\n{}", posted.text);
    }
}

#[test]
fn every_block_leads_back_to_its_record() {
    let text = records(&["20000,0,FEDRAT,100.,PERMIN", "5000,5,'',0,10.,.,.,20.,.,.", "20000,0,STOP"]);
    let posted = postprocess(&text, &wide());
    assert_eq!(blocks(&posted), ["G01 X+00010000 F00100", "X+00020000", "M00"]);
    let pairs: Vec<(&str, &str)> = posted
        .map
        .iter()
        .map(|(source, text_range)| (&text[source.clone()], &posted.text[text_range.clone()]))
        .collect();
    assert_eq!(
        pairs,
        [
            ("1,9000,9,1;", ""),
            ("2,20000,0,FEDRAT,100.,PERMIN;", ""),
            ("3,5000,5,'',0,10.,.,.,20.,.,.;", "N0001 G01 X+00010000 F00100\nN0002 X+00020000\n"),
            ("4,20000,0,STOP;", "N0003 M00\n"),
            ("6,14000;", ""),
            ("5,20000,0,END;", "N0004 M02\n"),
        ]
    );
}

#[test]
fn cl_text_leads_back_to_itself() {
    let text = "PARTNO / PLATE\nUNITS / MM\nFEDRAT / 100.0, MMPM\nGOTO / 10.0, 0.0, $\n 0.0\nGOTO / 900000.0, 0.0, 0.0\nFINI\n";
    let posted = postprocess(text, &wide());
    let error = &posted.diagnostics[0];
    assert_eq!((error.id, &text[error.range.clone()]), ("CONV-09", "GOTO / 900000.0, 0.0, 0.0"));
    let (statement, block) = posted.map.iter().find(|(_, text)| !text.is_empty()).unwrap();
    assert_eq!(&text[statement.clone()], "GOTO / 10.0, 0.0, $\n 0.0");
    assert_eq!(&posted.text[block.clone()], "N0001 G01 X+00010000 F00100 (INCOMPLETE) (PLATE)\n");
}

#[test]
fn what_is_lacking_stops_the_tape_and_is_said_at_its_start() {
    let text = records(&["20000,0,GOHOME", "20000,0,ORIGIN,1.,1.,1.", "20000,0,RAPID", "5000,5,'',0,10.,.,."]);
    let posted = postprocess(&text, &wide());
    assert!(posted.is_incomplete());
    assert_eq!(found(&posted), ["POST-02", "POST-02"]);
    assert_eq!(blocks(&posted), ["M00 (INCOMPLETE) (NOT POSTED)", "G00 X+00010000"]);
}
