//! What the control holds behind a block, and how the tape passes through it: worked out by hand from the tapes.

use nctape::format::{Declared, Dimensions, FeedCoding, FeedUnit, Format, Itemized, Plane, Standard};
use nctape::{Fate, Registers, Stop, Tape, Turning, presets};

fn preset(id: &str) -> Tape {
    let preset = presets::all().into_iter().find(|preset| preset.id == id).expect("the preset");
    Tape::new(preset.source, &preset.format)
}

/// A tape from blocks, numbered from 1.
fn tape(format: &Format, blocks: &[&str]) -> Tape {
    let numbered = blocks.iter().enumerate().map(|(index, block)| format!("N{:03}{block}\n", index + 1));
    Tape::new(&format!("%\n{}", numbered.collect::<String>()), format)
}

fn milling() -> Format {
    Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42I+42J+42F4S4T2M2*").classified("CAM 333")
}

/// What the control holds behind the block with this sequence number.
fn behind(tape: &Tape, sequence: &str) -> Registers {
    let blocks = &tape.reading().blocks;
    let block = blocks.iter().position(|block| tape.sequence(block).as_deref() == Some(sequence));
    tape.registers(block.expect("the block")).expect("a block")
}

/// "Motion G01, Plane (G17)": a function that the tape does not state stands in parentheses.
fn modal(held: &Registers) -> String {
    let one = |modal: &nctape::Modal| {
        let code = modal.function.as_ref().map_or("none", |function| &function.code);
        match modal.stated {
            true => format!("{} {code}", modal.group.title()),
            false => format!("{} ({code})", modal.group.title()),
        }
    };
    held.modal.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn spindle(held: &Registers) -> Option<(Turning, &str)> {
    held.spindle.as_ref().map(|(turning, function)| (*turning, function.code.as_str()))
}

fn coolant(held: &Registers) -> Option<(bool, &str)> {
    held.coolant.as_ref().map(|(on, function)| (*on, function.code.as_str()))
}

fn tool(held: &Registers) -> Option<(&str, Option<&str>)> {
    held.tool.as_ref().map(|(word, change)| (word.as_str(), change.as_ref().map(|change| change.code.as_str())))
}

fn rate(rate: &Option<nctape::Rate>) -> Option<(&str, Option<f64>)> {
    rate.as_ref().map(|rate| (rate.word.as_str(), rate.per_minute))
}

#[test]
fn the_circular_tape_of_annex_e() {
    let tape = preset("annex-e-circular");
    let first = behind(&tape, "N001");
    assert_eq!(modal(&first), "Motion G01, Plane (G17), Dimensions (G91), Feed kind (G93)");
    assert_eq!(first.position, [10.0, 10.0, 20.0], "the set point");
    assert_eq!((rate(&first.feed), spindle(&first)), (None, Some((Turning::Still, "M05"))));

    // Incremental: (10, 10, 20) - Z 10, + (5, 5), + Y 18,284, + (15,858, 15,858).
    let fifth = behind(&tape, "N005");
    assert_eq!(fifth.position, [30.858, 49.142, 10.0]);
    // The reciprocal of time says no feed by itself.
    assert_eq!(rate(&fifth.feed), Some(("F0013", None)));
    assert_eq!(spindle(&fifth), Some((Turning::Clockwise, "M03")));

    // + (14,142, 5,858).
    let sixth = behind(&tape, "N006");
    assert_eq!(modal(&sixth), "Motion G02, Plane (G17), Dimensions (G91), Feed kind (G93)");
    assert_eq!(sixth.modal[0].function.as_ref().unwrap().meaning, "Circular interpolation, arc clockwise");
    assert_eq!(sixth.position, [45.0, 55.0, 10.0]);
    assert_eq!(sixth.sequence.as_deref(), Some("N006"));

    let last = behind(&tape, "N012");
    assert_eq!(last.position, [10.0, 10.0, 20.0], "it closes on its set point");
    assert_eq!(spindle(&last), Some((Turning::Still, "M30")), "the end stops the spindle");
    assert_eq!(last.once.iter().map(|function| function.code.as_str()).collect::<Vec<_>>(), ["M30"]);
    assert_eq!((last.program, last.tool, last.coolant.map(|(on, _)| on)), (None, None, Some(false)));
}

#[test]
fn the_boring_tape_in_the_format_of_annex_d() {
    let tape = preset("annex-d-boring");
    let first = behind(&tape, "N001");
    assert_eq!(tool(&first), Some(("T01", Some("M06"))));
    assert_eq!(first.once.iter().map(|function| function.code.as_str()).collect::<Vec<_>>(), ["M06"]);

    // An arithmetic code of three digits: 6 is three digits before the decimal sign, 0,30 the leading ones: 300.
    let second = behind(&tape, "N002");
    assert_eq!(rate(&second.speed), Some(("S630", Some(300.0))));
    assert_eq!(spindle(&second), Some((Turning::Clockwise, "M03")));
    assert_eq!(second.position, [120.0, 85.0, 5.0]);
    assert!(second.once.iter().all(|function| function.code == "M03"));

    let seventh = behind(&tape, "N007");
    assert_eq!(spindle(&seventh), Some((Turning::Still, "M05")));
    // B is one digit: no dimension, but the place of an indexed table.
    assert_eq!(seventh.others, [('B', Some("B1".to_owned()))]);
    assert_eq!(behind(&tape, "N008").others, [('B', Some("B5".to_owned()))]);
    assert_eq!(first.others, [('B', None)]);

    let change = behind(&tape, "N009");
    assert_eq!(tool(&change), Some(("T02", Some("M06"))));

    // The first point of the arc in two blocks is held, but the tool has not left the start.
    assert_eq!(behind(&tape, "N013").position, [180.0, 85.0, -4.0]);
    assert_eq!(behind(&tape, "N014").position, [140.0, 85.0, -4.0]);
}

#[test]
fn functions_replace_those_of_their_group_and_no_others() {
    let blocks = ["G01G18G41G54G60G81", "G00G90", "G43", "G40", "G17G80G53M00"];
    let tape = tape(&milling(), &blocks);
    assert_eq!(
        modal(&behind(&tape, "N001")),
        "Motion G01, Plane G18, Dimensions (G90), Feed kind (G94), Cutter G41, Tool offset (none), Shift G54, \
         Positioning G60, Cycle G81"
    );
    assert!(modal(&behind(&tape, "N002")).starts_with("Motion G00, Plane G18, Dimensions G90, Feed kind (G94)"));
    assert!(modal(&behind(&tape, "N003")).contains("Cutter G41, Tool offset G43"));
    assert!(modal(&behind(&tape, "N004")).contains("Cutter G40, Tool offset (none)"), "d cancels the offsets");
    assert!(modal(&behind(&tape, "N005")).ends_with("Shift G53, Positioning G60, Cycle G80"));
}

#[test]
fn what_the_control_starts_with_is_the_formats() {
    let held = |format: &Format| modal(&tape(format, &["M03"]).registers(0).unwrap());
    let mut format = milling();
    assert_eq!(held(&format), "Motion (none), Plane (G17), Dimensions (G90), Feed kind (G94)");
    format.itemized = Itemized {
        plane: Some(Plane::Yz),
        feed_unit: Some(FeedUnit::PerRevolution),
        dimensions: Some(Dimensions::Incremental),
        ..Itemized::default()
    };
    // The words are absolute alone: the itemized data has nothing to decide.
    assert_eq!(held(&format), "Motion (none), Plane (G19), Dimensions (G90), Feed kind (G95)");
    format.detail = "N3G2XL42YL42F4M2*".to_owned();
    format.itemized.feed = Some(FeedCoding::TimeReciprocal);
    assert_eq!(held(&format), "Motion (none), Plane (G19), Dimensions (G91), Feed kind (G93)");
}

#[test]
fn feed_speed_coolant_and_tool() {
    let tape =
        tape(&milling(), &["F0300S0500M13", "G95F0002", "G96", "S0080M09", "T11", "T12", "M06", "M04", "M08", "M19"]);
    let first = behind(&tape, "N001");
    assert_eq!(rate(&first.feed), Some(("F0300", Some(300.0))));
    assert_eq!(rate(&first.speed), Some(("S0500", Some(500.0))));
    assert_eq!(spindle(&first), Some((Turning::Clockwise, "M13")));
    assert_eq!(coolant(&first), Some((true, "M13")));
    // 2 mm a revolution at 500 a minute.
    assert_eq!(rate(&behind(&tape, "N002").feed), Some(("F0002", Some(1000.0))));
    // A cutting speed asks for another S word, and says no revolutions.
    assert_eq!(rate(&behind(&tape, "N003").speed), None);
    let fourth = behind(&tape, "N004");
    assert_eq!(rate(&fourth.speed), Some(("S0080", None)));
    assert_eq!((coolant(&fourth), rate(&fourth.feed)), (Some((false, "M09")), Some(("F0002", None))));
    assert_eq!(tool(&behind(&tape, "N005")), Some(("T11", None)));
    assert_eq!(tool(&behind(&tape, "N006")), Some(("T12", None)));
    assert_eq!(tool(&behind(&tape, "N007")), Some(("T12", Some("M06"))));
    assert_eq!(spindle(&behind(&tape, "N008")), Some((Turning::CounterClockwise, "M04")));
    assert_eq!(coolant(&behind(&tape, "N009")), Some((true, "M08")));
    assert_eq!(spindle(&behind(&tape, "N010")), Some((Turning::Still, "M19")));
}

#[test]
fn a_position_that_could_not_be_read_is_said_to_be_a_guess() {
    let tape = tape(&milling(), &["G01X+001000Y+001000F0300", "X+1", "X+002000"]);
    assert_eq!(behind(&tape, "N001").doubtful, [false; 3]);
    assert_eq!(behind(&tape, "N002").doubtful, [true, false, false]);
    assert_eq!(behind(&tape, "N003").doubtful, [false; 3]);
}

#[test]
fn skipped_blocks_and_what_stands_behind_the_end_change_nothing() {
    let source = "%12\nN001G01X+001000F0300\n/N002X+002000F0100M08\nN003M00\nN004M02\nN005G00X+009000\n%13\nN001M03\n";
    let fates = |tape: &Tape| tape.course().steps.iter().map(|step| step.fate).collect::<Vec<_>>();
    use Fate::*;
    let whole = Tape::new(source, &milling());
    assert_eq!(fates(&whole), [Executed, Executed, Executed, Executed, Unreached, Executed]);
    let stops: Vec<Stop> = whole.course().steps.iter().map(|step| step.stop).collect();
    assert_eq!(stops, [Stop::None, Stop::None, Stop::Program, Stop::End, Stop::None, Stop::None]);
    let stop = |block| whole.registers(block).unwrap().stop.map(|stop| stop.code);
    assert_eq!([0, 2, 3].map(stop), [None, Some("M00".to_owned()), Some("M02".to_owned())]);
    assert_eq!(whole.registers(1).unwrap().position[0], 20.0);

    let tape = Tape::with_skip(source, &milling(), true);
    assert_eq!(fates(&tape), [Executed, Skipped, Executed, Executed, Unreached, Executed]);
    let skipped = tape.registers(1).unwrap();
    assert_eq!((skipped.fate, skipped.position[0], skipped.coolant), (Skipped, 10.0, None));
    assert_eq!((skipped.sequence.as_deref(), skipped.once), (Some("N001"), vec![]));
    let unreached = tape.registers(4).unwrap();
    assert_eq!((unreached.fate, unreached.position[0]), (Unreached, 10.0));
    assert_eq!(unreached.program.as_deref(), Some("12"));

    // Another program: the modal functions are those of the start, the tool stays where it is.
    let next = tape.registers(5).unwrap();
    assert_eq!(next.program.as_deref(), Some("13"));
    assert_eq!(modal(&next), "Motion (none), Plane (G17), Dimensions (G90), Feed kind (G94)");
    assert_eq!((next.position[0], next.feed.is_none()), (10.0, true));
    assert_eq!(tape.registers(6), None);
}

#[test]
fn some_blocks_at_once_are_the_same_as_each_by_itself() {
    for preset in presets::tapes() {
        let tape = Tape::new(preset.source, &preset.format);
        let count = tape.reading().blocks.len();
        let one_by_one: Vec<Registers> = (0..count).filter_map(|block| tape.registers(block)).collect();
        assert_eq!(tape.registers_of(0..count + 7), one_by_one, "{}", preset.id);
        assert_eq!(tape.registers_of(2..5), one_by_one[2..count.clamp(2, 5)], "{}", preset.id);
    }
}

#[test]
fn far_into_a_long_tape_the_control_holds_the_same_as_executed_from_the_start() {
    let mut format = milling();
    format.detail = "N3G2XL42YL42IL42JL42F4S4T2M2*".to_owned();
    // Five blocks again and again, among them an arc in two blocks, whose point between is held.
    let round = ["G01G91X+000100F0300", "Y+000100M08", "G03X+000200Y+000200", "X-000200Y+000200", "G01X-000100M09"];
    let source: String = (0..200).flat_map(|_| round).map(|block| format!("N001{block}\n")).collect();
    let tape = Tape::new(&format!("%\n{source}"), &format);
    let all = tape.registers_of(0..1000);
    assert_eq!(all.len(), 1000);
    // Each round goes by Y + 1 + 2 + 2, and X comes back.
    assert_eq!(all[999].position, [0.0, 1000.0, 0.0]);
    for block in (0..1000).step_by(7).chain(250..265).chain(505..520) {
        assert_eq!(tape.registers(block).as_ref(), Some(&all[block]), "{block}");
    }
}

#[test]
fn the_pace_is_that_of_the_spans_or_of_the_reader() {
    let mut format = milling();
    let blocks = ["G00X+001000", "G01X+004000F0300", "M05", "G02X+006000Y+000000I+005000J+000000M30"];
    let course = tape(&format, &blocks).course();
    // "N001G00X+001000" and its end of block: 16 rows, behind the percent sign and the end of block that leads.
    assert_eq!(course.steps[0].rows, 2..18);
    assert_eq!(course.steps[1].rows, 18..39);
    // 10 mm of rapid at the assumed 5000 mm/min; 30 mm at 300 mm/min; 8 rows at 300 a second.
    assert_eq!((course.assumed, course.note.as_deref()), (1, Some("Assumed for the replay: rapid 5000 mm/min")));
    assert_eq!(course.steps[0].seconds, 10.0 / 5000.0 * 60.0);
    assert_eq!(course.steps[1].seconds, 6.0);
    assert_eq!((course.steps[2].rows.clone(), course.steps[2].seconds), (39..47, 8.0 / 300.0));
    assert_eq!(course.steps.iter().map(|step| step.spans.clone()).collect::<Vec<_>>(), [0..1, 1..2, 2..2, 2..3]);
    // Half a circle of radius 10 at 300 mm/min.
    assert!((course.steps[3].seconds - std::f64::consts::PI * 10.0 / 5.0).abs() < 1e-9);

    format.itemized.reader_speed = Some(nctape::format::value::Positive(100.0));
    assert_eq!(tape(&format, &blocks).course().steps[2].seconds, 8.0 / 100.0);
}

#[test]
fn a_span_of_two_blocks_is_carried_out_with_its_last() {
    let course = preset("annex-d-boring").course();
    // N013 is the point between, N014 the end: F0002 is half a minute.
    let (middle, end) = (&course.steps[12], &course.steps[13]);
    assert!(middle.spans.is_empty() && middle.seconds < 1.0);
    assert_eq!((end.spans.len(), end.seconds), (1, 30.0));
}

#[test]
fn no_time_is_beyond_counting() {
    let mut format = milling();
    format.itemized.reader_speed = Some(nctape::format::value::Positive(f64::MIN_POSITIVE));
    let source = "%\nN001G01X+001000F0300\nN002M05\n".repeat(200);
    let course = Tape::new(&source, &format).course();
    assert!(course.steps.iter().map(|step| step.seconds).sum::<f64>().is_finite());
}

#[test]
fn functions_say_their_group_and_when_they_act() {
    let mut format = milling();
    let m = [("M06".to_owned(), "after the motion".to_owned())].into_iter().collect();
    format.itemized.declared = Some(Declared { m, ..Declared::default() });
    let tape = tape(&format, &["G01G43M05", "T01M06", "M48"]);
    let first = behind(&tape, "N001");
    let named = |function: &nctape::Named| (function.code.clone(), function.group, function.acts.clone());
    let stays = "until another function of its group";
    let motion = first.modal[0].function.as_ref().unwrap();
    assert_eq!(named(motion), ("G01".to_owned(), "Motion", stays.to_owned()));
    let after = format!("after the motion of the block, {stays}");
    assert_eq!(named(&first.once[0]), ("M05".to_owned(), "Spindle", after.clone()));
    // What the table leaves open is what the builder declares.
    let change = behind(&tape, "N002").once;
    assert_eq!(named(&change[0]), ("M06".to_owned(), "Tool", "after the motion".to_owned()));
    let offset = first.modal.iter().find_map(|modal| modal.function.as_ref().filter(|it| it.code == "G43"));
    assert!(offset.unwrap().conflict.unwrap().contains("RS-274-D"));
    assert!(behind(&tape, "N003").once[0].conflict.is_some(), "the sources differ on M48");
    assert_eq!(behind(&tape, "N003").once[0].acts, after);
}

/// 3.3.4.5: the last group of digits of T selects the tool compensation; where it has a word of its own, that is D.
#[test]
fn the_number_of_the_tool_compensation() {
    let mut format = Format::new(Standard::Iso2539, "N3G2X+42Y+42F4T4M2*").classified("CAM 222");
    let blocks = ["T0503M06", "G41X+001000", "T0604"];
    let number = |format: &Format, sequence: &str| behind(&tape(format, &blocks), sequence).compensation;
    assert_eq!(number(&format, "N003"), None, "no digits of T are said to select it");
    format.itemized.compensation_digits = Some(2);
    assert_eq!(number(&format, "N002").as_deref(), Some("03"));
    assert_eq!(number(&format, "N003").as_deref(), Some("04"));
    // A character that no code has stands among the digits.
    let odd = tape(&format, &["T050\u{e9}3M06"]);
    assert_eq!(behind(&odd, "N001").compensation.as_deref(), Some("03"));

    let mut format = Format::new(Standard::Iso2539, "N3G2X+42Y+42F4D2T2M2*").classified("CAM 222");
    let letters = [("D".to_owned(), "tool compensation".to_owned())].into_iter().collect();
    format.itemized.declared = Some(Declared { letters, ..Declared::default() });
    let with_d = tape(&format, &["G42X+001000D07", "G40"]);
    assert_eq!(behind(&with_d, "N001").compensation.as_deref(), Some("07"));
    assert_eq!(behind(&with_d, "N002").compensation.as_deref(), Some("07"), "G40 cancels the offset, not its number");
}
