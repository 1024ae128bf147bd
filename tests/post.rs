//! The post-processor: CLDATA becomes tapes that do what it says.

use nctape::post::{Options, postprocess, postprocess_with};
use nctape::{Format, Severity, Standard, Tape, presets};
use std::path::Path;

/// The format of a preset.
fn format_of(id: &str) -> (Format, &'static str) {
    let preset = presets::all().into_iter().find(|preset| preset.id == id).expect("the preset");
    (preset.format, preset.source)
}

/// The words of each block that have one of these addresses, as they stand.
fn words<'a>(text: &'a str, letters: &str) -> Vec<Vec<&'a str>> {
    let of = |line: &'a str| line.split(['\t', ' ']).filter(|word| word.starts_with(|c| letters.contains(c))).collect();
    text.lines().filter(|line| line.starts_with('N')).map(of).collect()
}

#[test]
fn second() {
    let format = Format::new(Standard::Iso2539, "N4G2X+53Y+53Z+53I+53J+53K+53F5S5T2M2*").classified("CAM 333");
    let text = "1,9000,9,1;2,20000,0,FEDRAT,100.,PERMIN;3,5000,3,'',0,1.,.,.;4,5000,5,'',0,4.,.,.;5,20000,0,FOO;6,20000,0,BAR;7,5000,5,'',0,4.,.,500000.;8,5000,5,'',0,4.,.,5.;9,14000;:1,5000,3,'',0,4.,.,5.;2,20000,0,RAPID;3,5000,5,'',0,40.,.,.;4,14000;:";
    let posted = postprocess(text, &format);
    println!(
        "{}\n{:?}\n{:?}",
        posted.text,
        posted.diagnostics.iter().map(|d| (d.id, &d.message)).collect::<Vec<_>>(),
        posted.map
    );
    let tape = Tape::new(&posted.text, &format);
    for span in &tape.spans().list {
        println!("{:?} {:?} {:?}", span.kind, span.start, span.end)
    }
    for d in tape.diagnostics() {
        println!("{} {}", d.id, d.message)
    }
}

#[test]
fn show() {
    let (format, source) = format_of("annex-e-circular");
    let cldata = include_str!("cldata/annex_e.cld");
    let posted = postprocess_with(cldata, &format, &Options { quadrants: true, ..Options::default() });
    println!(
        "{}\n{:?}\n{:?}",
        posted.text,
        posted.diagnostics.iter().map(|d| (d.id, &d.message)).collect::<Vec<_>>(),
        posted.map
    );
    let _ = source;
    for file in ["bohren_1.cld", "profilfraesen_2.cld", "bohren_1.ncl"] {
        let text = std::fs::read_to_string(
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cldata/creopost").join(file),
        )
        .unwrap();
        let format = Format::new(Standard::Iso2539, "N4G2X+53Y+53Z+53I+53J+53K+53F5S5T2M2*").classified("CAM 333");
        let posted = postprocess(&text, &format);
        println!("{} {}", posted.text.len(), posted.diagnostics.len());
        for found in Tape::new(&posted.text, &format).diagnostics() {
            if found.severity > Severity::Info {
                println!("{} {}", found.id, found.message)
            }
        }
    }
}
