//! `cargo bench --bench cldata`: how fast CLDATA is read, carried out and checked, and made a punched tape.

#[path = "../tape/measure.rs"]
#[allow(dead_code, reason = "only some of the measures are taken here")]
mod measure;

use measure::{Contestant, TIMES_HEAD, TIMES_RULE, compete, grouped, shown};
use nctape::cldata::{Cldata, Options};
use nctape::post::postprocess;
use nctape::{Format, Standard, Tape};
use std::fmt::Write;
use std::hint::black_box;
use std::time::Duration;

const RECORDS: usize = 100_000;

/// A milled profile with an arc in every sixth pair of records, as a CAM system writes it: each motion behind the
/// identification of its statement.
fn profile(records: usize) -> String {
    let mut text = String::from(
        "1,9000,9,1;\n2,20000,0,SPINDL,RPM,9000.,CLW;\n3,20000,0,FEDRAT,400.,MMPM;\n4,5000,3,'',0,.,.,2.;\n",
    );
    let mut next = 5;
    let (mut x, mut y) = (0.0_f64, 0.0_f64);
    while next + 2 < records {
        let step = next / 2;
        writeln!(text, "{next},1000,{step},'';").expect("a text takes all");
        if step % 6 == 0 {
            writeln!(text, "{},3000,2,0,4,9,'',0,{x:.4},{:.4},-1.5,.,.,1.,1.5;", next + 1, y + 1.5).expect("likewise");
            (x, y) = (x + 1.5, y + 1.5);
            writeln!(text, "{},5000,5,'',0,{x:.4},{y:.4},-1.5;", next + 2).expect("likewise");
            next += 3;
        } else {
            (x, y) = (x + 0.0123 * (step % 7) as f64, y + 0.0457);
            writeln!(text, "{},5000,5,'',0,{x:.4},{y:.4},-1.5;", next + 1).expect("likewise");
            next += 2;
        }
    }
    while next < records {
        writeln!(text, "{next},20000,0,PPRINT,'END';").expect("likewise");
        next += 1;
    }
    writeln!(text, "{next},14000;\n:").expect("likewise");
    text
}

fn main() {
    let text = profile(RECORDS);
    let cldata = Cldata::new(&text, &Options::default());
    let faults = cldata.diagnostics().iter().filter(|found| found.severity > nctape::Severity::Info).count();
    assert_eq!((cldata.records().len(), faults), (RECORDS, 0), "{:?}", cldata.diagnostics().first());
    let check = |columns: Option<usize>| {
        black_box(Cldata::new(black_box(&text), &Options { columns, dialect: None }));
    };
    let format = Format::new(Standard::Iso2539, "N6G2X+53Y+53Z+53I+53J+53F4S5T2M2*").classified("CAM 333");
    let posted = postprocess(&text, &format);
    assert!(!posted.is_incomplete(), "{:?}", posted.diagnostics.first());
    let mut contestants: [Contestant<'_>; 4] = [
        ("read, carried out and checked, as a stream", Box::new(|| check(None))),
        ("the same in 72 columns", Box::new(|| check(Some(72)))),
        (
            "read and posted to tape text",
            Box::new(|| {
                black_box(postprocess(black_box(&text), &format));
            }),
        ),
        (
            "read, posted and punched: to rows of holes",
            Box::new(|| {
                let posted = postprocess(black_box(&text), &format);
                black_box(Tape::new(&posted.text, &format).rows());
            }),
        ),
    ];
    let times = compete(&mut contestants, Duration::from_secs(10));
    println!(
        "\n{} records of CLDATA, {} bytes, and the tape of {} blocks that they become.\n",
        grouped(RECORDS),
        grouped(text.len()),
        grouped(posted.text.matches('\n').count() - 1)
    );
    println!("| what | {TIMES_HEAD} | a record |");
    println!("| --- | {TIMES_RULE} | --: |");
    for ((name, _), times) in contestants.iter().zip(&times) {
        println!("| {name} | {times} | {} |", shown(times.median() / RECORDS as u32));
    }
}
