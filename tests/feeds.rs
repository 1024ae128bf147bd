//! Feeds and times of spans, worked by hand: dwells, threads, rotary axes.

use nctape::format::{Dwell, DwellUnit, FeedUnit, Format, Standard};
use nctape::span::SpanKind;
use nctape::{Severity, Tape};

fn format() -> Format {
    Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42I42J42K42F4S4T2M2*").classified("CAM 333")
}

fn run(format: &Format, blocks: &[&str]) -> Tape {
    let numbered = blocks.iter().enumerate().map(|(index, block)| format!("N{:03}{block}\n", index + 1));
    Tape::new(&format!("%\n{}", numbered.collect::<String>()), format)
}

fn dwelling(address: char, unit: DwellUnit) -> Format {
    let mut format = format();
    format.itemized.dwell = Some(Dwell { address, unit });
    format
}

fn seconds(tape: &Tape) -> Vec<Option<f64>> {
    tape.spans().list.iter().map(|span| span.seconds).collect()
}

fn ids(tape: &Tape) -> Vec<&'static str> {
    tape.diagnostics()
        .iter()
        .filter(|found| found.severity > Severity::Info || found.id == "FUN-09")
        .map(|f| f.id)
        .collect()
}

#[test]
fn a_dwell_is_a_span_that_moves_nothing_and_takes_its_time() {
    let tape = run(&dwelling('X', DwellUnit::Seconds), &["G01X+001000F0300", "G04X+000150", "Y+001000M30"]);
    let [before, dwell, behind] = &tape.spans().list[..] else { panic!("{:?}", tape.spans().list) };
    assert_eq!((dwell.kind, dwell.blocks, dwell.length), (SpanKind::Dwell, (1, 1), 0.0));
    assert_eq!((dwell.start, dwell.end), ([10.0, 0.0, 0.0], [10.0, 0.0, 0.0]), "X says the time and moves nothing");
    assert_eq!((dwell.seconds, dwell.feed), (Some(1.5), None));
    assert_eq!((before.end, behind.start, behind.end), (dwell.start, dwell.end, [10.0, 10.0, 0.0]));
    let totals = tape.totals();
    assert_eq!((totals.cutting, totals.rapid, totals.seconds), (20.0, 0.0, Some(5.5)));
    assert_eq!(ids(&tape), [""; 0]);
    // The course waits, and the points stand.
    assert_eq!(tape.course().steps[1].seconds, 1.5);
    assert_eq!(tape.points_of(1..2, 0.01).xyz, [10.0, 0.0, 0.0, 10.0, 0.0, 0.0]);
    let held = tape.registers(1).unwrap();
    let said = held.dwell.unwrap();
    assert_eq!((said.word.as_str(), said.seconds), ("X+000150", Some(1.5)));
    assert_eq!(held.position, [10.0, 0.0, 0.0]);
    assert_eq!(tape.registers(2).unwrap().dwell, None);
}

#[test]
fn a_dwell_in_revolutions_needs_the_spindle_speed() {
    let format = dwelling('F', DwellUnit::Revolutions);
    // 30 revolutions at 600 a minute are three seconds; F is no feed there, and S counts wherever it stands.
    let tape = run(&format, &["G01X+001000F0300", "G04F0030S0600", "X+002000M30"]);
    assert_eq!(seconds(&tape), [Some(2.0), Some(3.0), Some(2.0)]);
    let feed = tape.registers(1).unwrap().feed.unwrap();
    assert_eq!((feed.word.as_str(), feed.per_minute), ("F0300", Some(300.0)));

    let tape = run(&format, &["G01X+001000F0300", "G04F0030", "X+002000M30"]);
    assert_eq!(seconds(&tape), [Some(2.0), None, Some(2.0)]);
    assert_eq!(tape.totals().seconds, None, "a time that is not known is in no sum");
}

#[test]
fn a_dwell_that_says_no_time_is_said_to_be_left_out() {
    for (format, block) in [
        (format(), "G04X+000150"),
        (dwelling('X', DwellUnit::Seconds), "G04"),
        (dwelling('X', DwellUnit::Seconds), "G04X-000150"),
    ] {
        let tape = run(&format, &["G01X+001000F0300", block, "X+002000M30"]);
        assert_eq!(ids(&tape), ["FUN-09"], "{block}");
        assert_eq!(seconds(&tape), [Some(2.0), Some(2.0)], "{block}");
    }
    // None at all is none.
    let tape = run(&dwelling('X', DwellUnit::Seconds), &["G01X+001000F0300", "G04X+000000", "X+002000M30"]);
    assert_eq!((ids(&tape), seconds(&tape)), (vec![], vec![Some(2.0), Some(2.0)]));
}

#[test]
fn a_dwell_leaves_a_span_of_two_blocks_unfinished() {
    let format = dwelling('X', DwellUnit::Seconds);
    let tape = run(&format, &["G01F0300", "G02X+001000Y+001000", "G04X+000150", "G01X+002000M30"]);
    assert_eq!(ids(&tape), ["MOT-07"]);
    let kinds: Vec<_> = tape.spans().list.iter().map(|span| (span.kind, span.substitute)).collect();
    assert_eq!(kinds, [(SpanKind::Line, true), (SpanKind::Dwell, false), (SpanKind::Line, false)]);
}

#[test]
fn a_thread_goes_on_by_its_lead_with_every_revolution() {
    // 20 mm at 2 mm a turn and 500 turns a minute: 10 turns, 1,2 seconds, 1000 mm/min, whatever F says.
    let tape = run(&format(), &["G01X+001000F0300S0500", "G33Z-002000K000200", "Z+000000M30"]);
    let thread = &tape.spans().list[1];
    assert_eq!((thread.kind, thread.feed, thread.seconds), (SpanKind::Line, Some(1000.0), Some(1.2)));
    assert_eq!(tape.spans().list[2].seconds, Some(1.2), "a lead holds on until another is given");
    assert_eq!(ids(&tape), [""; 0]);

    // A taper: the lead is along Z, the feed along the path: 10 turns of hypot(20, 15) / 10.
    let tape = run(&format(), &["G01F0300S0500", "G33X+001500Z-002000K000200M30"]);
    let taper = &tape.spans().list[0];
    assert_eq!((taper.length, taper.seconds), (25.0, Some(1.2)));
    assert!((taper.feed.unwrap() - 1250.0).abs() < 1e-9);

    // Two leads: the axis that needs more turns says how many, here X with 15 of 1 mm.
    let tape = run(&format(), &["G01F0300S0500", "G33X+001500Z-002000I000100K000200M30"]);
    assert!((tape.spans().list[0].seconds.unwrap() - 1.8).abs() < 1e-12);
}

#[test]
fn the_time_of_a_thread_is_not_known_without_lead_or_speed() {
    for blocks in [
        ["G01F0300", "G33Z-002000K000200M30"],
        ["G01F0300S0500", "G33Z-002000M30"],
        ["G01F0300S0500", "G33Z-002000I000200M30"],
        ["G01F0300S0500", "G34Z-002000K000200M30"],
        ["G01F0300S0000", "G33Z-002000K000200M30"],
    ] {
        let tape = run(&format(), &blocks);
        assert_eq!((tape.spans().list[0].feed, tape.spans().list[0].seconds), (None, None), "{blocks:?}");
    }
}

#[test]
fn a_thread_without_i_j_and_k_has_its_lead_in_f() {
    // ISO 1058 A.1.2.1: millimetres a turn, 2 of them; in the inch system turns an inch, 8 of them.
    for (class, blocks, turns) in
        [("LAM 331", ["G33Z-02000F26S56"], 20.0 / 20.0), ("LAI 331", ["G33Z-02000F38S56"], 20.0 * 80.0)]
    {
        let format = Format::new(Standard::Iso1058, "N3G2X+32Y+32Z+32F2S2T2M2*").classified(class);
        let tape = run(&format, &blocks);
        // S56 is 630 turns a minute; F26 says 20, F38 says 80.
        let seconds = tape.spans().list[0].seconds.unwrap();
        assert!((seconds - turns / 630.0 * 60.0).abs() < 1e-12, "{class}: {seconds}");
    }
    // Elsewhere a feed per revolution is one.
    let mut format = format();
    format.itemized.feed_unit = Some(FeedUnit::PerRevolution);
    let tape = run(&format, &["G33Z-002000F0002S0500M30"]);
    assert_eq!(tape.spans().list[0].seconds, Some(1.2));
}

/// A.2.1: a rotary axis that moves alone has its own length and its own feed, degrees or turns per minute.
#[test]
fn a_rotary_axis_alone_turns_at_a_feed_of_its_own_unit() {
    for (class, block, wanted) in [
        // 90 degrees at 180 degrees a minute; a quarter of a turn at 3 turns a minute.
        ("CAMD 222", "G01B+090000F0180M30", 30.0),
        ("CAMR 222", "G01B+000250F0003M30", 5.0),
        // The reciprocal of time says the time itself.
        ("CAMD 222", "G93G01B+090000F0004M30", 15.0),
    ] {
        let format = Format::new(Standard::Iso2539, "N3G2X+42B+33F4M2*").classified(class);
        let tape = run(&format, &[block]);
        assert_eq!(seconds(&tape), [Some(wanted)], "{block}");
        assert_eq!(tape.totals().cutting, 0.0, "it cuts no length");
    }
    // Together with a linear axis the feed is that of the path: 10 mm at 300 mm/min.
    let format = Format::new(Standard::Iso2539, "N3G2X+42B+33F4M2*").classified("CAMD 222");
    assert_eq!(seconds(&run(&format, &["G01X+001000B+090000F0300M30"])), [Some(2.0)]);
}

/// Thirty rows a second; the blocks have 21, 13 and 8 rows, and are cut in 2, 0,2 and no time.
fn slow() -> (Format, [&'static str; 3]) {
    let mut format = format();
    format.itemized.reader_speed = Some(nctape::format::value::Positive(30.0));
    (format, ["G01X+001000F0300", "X+001100", "M30"])
}

#[test]
fn a_block_starves_that_is_cut_faster_than_it_is_read() {
    let (mut format, blocks) = slow();
    let tape = run(&format, &blocks);
    let times = tape.times(0..usize::MAX);
    assert_eq!(times.executing, [Some(2.0), Some(0.2), Some(0.0)]);
    assert_eq!(times.reading, [21.0 / 30.0, 13.0 / 30.0, 8.0 / 30.0]);
    assert_eq!(times.starved, [false, true, false]);
    assert_eq!(tape.times(1..2).reading, [13.0 / 30.0], "a stretch is that of the whole");

    let time = tape.time();
    let near = |one: Option<f64>, other: f64| (one.unwrap() - other).abs() < 1e-12;
    assert!(near(time.executing, 2.2));
    // The longer of the two for each block, or both.
    assert!(near(time.buffered, 2.0 + 13.0 / 30.0 + 8.0 / 30.0));
    assert!(near(time.unbuffered, 2.2 + 42.0 / 30.0));
    assert!(near(Some(time.reading), 42.0 / 30.0));
    assert_eq!(time.starved, 1);
    assert!(near(Some(time.waiting), 13.0 / 30.0 - 0.2));
    format.itemized.buffered = Some(false);
    let tape = run(&format, &blocks);
    assert!(near(Some(tape.time().waiting), 13.0 / 30.0), "without a buffer it waits for all of the reading");
    let found = tape.diagnostics().into_iter().find(|found| found.id == "FEED-15").unwrap();
    assert_eq!((found.severity, found.count), (Severity::Warning, 1));
}

#[test]
fn no_time_is_told_of_what_is_not_known() {
    let (format, _) = slow();
    let tape = run(&format, &["G00X+001000", "G01X+002000F0300", "M30", "X+003000"]);
    let times = tape.times(0..usize::MAX);
    assert_eq!(times.executing, [None, Some(2.0), Some(0.0), Some(0.0)]);
    assert_eq!(times.reading[3], 0.0, "behind the end nothing is read");
    let time = tape.time();
    assert_eq!((time.executing, time.buffered, time.unbuffered), (None, None, None));
    assert!(time.reading > 0.0);
    assert!(time.sentences(&format)[0].contains("not known"));
}

#[test]
fn the_blocks_of_an_arc_in_two_are_read_together() {
    let (format, _) = slow();
    // A quarter of radius 10 in 15,7 mm, 3,1 s; its blocks have 24 and 21 rows, 1,5 s.
    let tape = run(&format, &["G01F0300", "G02X+000293Y+000707", "X+001000Y+001000M30"]);
    assert_eq!(tape.times(0..3).starved, [false; 3]);
    // The arc alone is cut while the next two blocks like its own are read: only the first block is waited for.
    let buffered = tape.time().buffered.unwrap() - tape.times(0..1).reading[0];
    assert!((buffered - 10.0 * std::f64::consts::FRAC_PI_2 / 300.0 * 60.0).abs() < 1e-3, "{buffered}");
    let tape = run(&format, &["G01F1200", "G02X+000293Y+000707", "X+001000Y+001000M30"]);
    assert_eq!(tape.times(0..3).starved, [false, false, true]);
    let found = tape.diagnostics().into_iter().find(|found| found.id == "FEED-15").unwrap();
    assert!(tape.text()[found.range.clone()].starts_with("N002"), "said at the first of them");
}

#[test]
fn rows_of_zeros_that_a_format_could_let_go() {
    let zeros = |detail: &str, block: &str| {
        let format = Format::new(Standard::Iso2539, detail).classified("CAM 222");
        let zeros = Tape::new(&format!("%\n{block}\n"), &format).time().zeros;
        (zeros.leading, zeros.trailing, zeros.permitted)
    };
    // Every digit is punched: 001200 has two before its first and two behind its last; of 000000 one stays.
    assert_eq!(zeros("N3G2X+42Y+42M2*", "N001G01X+001200Y+000000M30"), (2 + 5, 2 + 5, 0));
    // Zeros before the number may go, and were not left out.
    assert_eq!(zeros("N3G2X+042Y+042M2*", "N001G01X+001200Y+12M30"), (2, 2, 2));
    // Zeros behind it may go: 0012 is 001200.
    assert_eq!(zeros("N3G2X+420Y+420M2*", "N001G01X+0012Y+001200M30"), (2 + 2, 2, 2));
}

/// A speed under every method, and a code: against figures of the printed tables.
#[test]
fn a_speed_is_compared_under_every_method() {
    use nctape::format::{Control, FeedCoding};
    use nctape::speed::{Compared, Comparison};
    let mut comparison = Comparison::new(Control::new(&format()), true);
    comparison.length = Some(11.716);
    comparison.radius = Some(20.0);
    let codes =
        |rows: Vec<Compared>| -> Vec<String> { rows.into_iter().map(|row| row.code.unwrap_or_default()).collect() };
    let rows = comparison.codes(300.0);
    // Annex E's N009 is F0025; 300/20 radians a minute; 630, 6300, 63000 say 300; 50 is 315; no table; itself.
    assert_eq!(codes(rows.clone()), ["0025", "0015", "630", "6300", "63000", "50", "", "0300"]);
    assert!((rows[0].deviation.unwrap() + 2.3667).abs() < 1e-3, "never above: {:?}", rows[0]);
    assert_eq!(rows[5].deviation, Some(5.0));
    assert!(rows[7].in_force && !rows[2].in_force);
    assert!(rows[6].note.contains("symbolicFeeds"));

    let said = |written: &str| -> Vec<Option<f64>> {
        comparison.speeds(written).unwrap().into_iter().map(|row| row.speed).collect()
    };
    assert_eq!(said("50"), [Some(50.0 * 11.716), Some(1000.0), None, Some(315.0), None, Some(50.0)]);
    assert_eq!(said("615")[2], Some(150.0));
    assert!(comparison.speeds("99").unwrap()[3].rapid);
    assert_eq!(comparison.speeds("F12"), None);
    let spindle = Comparison::new(Control::new(&format()), false);
    assert_eq!(
        (spindle.unit(), codes(spindle.codes(1728.0))),
        (
            "rev/min",
            vec![
                "717".to_owned(),
                "7173".to_owned(),
                "71728".to_owned(),
                "65".to_owned(),
                String::new(),
                "1728".to_owned()
            ]
        )
    );
    assert!(spindle.codes(10.0).iter().all(|row| row.method != FeedCoding::TimeReciprocal));
}
