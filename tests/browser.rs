//! The JavaScript interface in a headless browser: the figures of the printed tapes, as a script gets them.

#![cfg(target_arch = "wasm32")]

#[path = "support/edits.rs"]
mod edits;

use js_sys::{Array, Float64Array, Object, Reflect, Uint32Array};
use nctape_wasm as api;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

fn get(object: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(object.clone(), |value, name| Reflect::get(&value, &name.into()).expect("an object"))
}

fn number(object: &JsValue, path: &str) -> f64 {
    get(object, path).as_f64().expect("a number")
}

fn text(object: &JsValue, path: &str) -> String {
    get(object, path).as_string().expect("a text")
}

fn list(object: &JsValue, path: &str) -> Vec<JsValue> {
    get(object, path).unchecked_into::<Array>().to_vec()
}

fn preset(id: &str) -> JsValue {
    let presets: Array = api::presets().unchecked_into();
    presets.iter().find(|preset| text(preset, "id") == id).expect("the preset")
}

fn check(preset: &JsValue) -> JsValue {
    api::check(&get(preset, "source"), &get(preset, "format"), &JsValue::UNDEFINED).expect("no malformed argument")
}

fn rules_of(report: &JsValue, severity: &str) -> Vec<String> {
    let found = list(report, "diagnostics");
    found.iter().filter(|found| text(found, "severity") == severity).map(|found| text(found, "rule")).collect()
}

#[wasm_bindgen_test]
fn the_circular_tape_of_annex_e() {
    let report = check(&preset("annex-e-circular"));
    assert_eq!(rules_of(&report, "error"), [""; 0]);
    assert_eq!(rules_of(&report, "warning"), [""; 0]);

    let spans = list(&report, "spans");
    let end = get(&spans[spans.len() - 1], "end");
    // It closes on its set point, to the bit.
    assert_eq!(Array::from(&end).to_vec(), [10.0, 10.0, 20.0].map(JsValue::from));

    let arcs: Vec<&JsValue> = spans.iter().filter(|span| text(span, "kind") == "arc").collect();
    assert_eq!(arcs.len(), 3);
    for arc in arcs {
        assert!((number(arc, "sweep").abs() - std::f64::consts::FRAC_PI_4).abs() < 1e-6);
        let (centre, start) = (get(arc, "centre"), get(arc, "start"));
        let radius = distance(&centre, &start);
        assert!((radius - 20.0).abs() < 2e-4, "{radius}");
    }
    assert!((number(&report, "totals.seconds") / 60.0 - 0.7861).abs() < 5e-5);
}

/// The distance of two points in XY. Written out, so that the test leans on nothing of the core.
fn distance(a: &JsValue, b: &JsValue) -> f64 {
    let (dx, dy) = (number(a, "0") - number(b, "0"), number(a, "1") - number(b, "1"));
    (dx * dx + dy * dy).sqrt()
}

#[wasm_bindgen_test]
fn the_parabolic_tape_of_annex_e() {
    let report = check(&preset("annex-e-parabolic"));
    assert_eq!(rules_of(&report, "error"), [""; 0]);
    let spans = list(&report, "spans");
    assert_eq!(spans.iter().filter(|span| text(span, "kind") == "parabola").count(), 5);
    assert!((number(&report, "totals.cutting") - 227.15).abs() < 0.005);
}

#[wasm_bindgen_test]
fn figure_2s_reading_of_annex_e_names_the_one_that_fits_and_offers_it() {
    let preset = preset("annex-e-circular");
    Reflect::delete_property(get(&preset, "format.itemized").unchecked_ref::<Object>(), &"arcCentre".into())
        .expect("an object");
    let report = check(&preset);
    assert_eq!(rules_of(&report, "error"), ["MOT-05"; 3]);

    let found = list(&report, "diagnostics").into_iter().find(|found| text(found, "rule") == "MOT-05");
    let found = found.expect("a finding");
    assert!(text(&found, "message").contains("start minus centre"));
    let fixes = list(&found, "fixes");
    let format = fixes.iter().map(|fix| get(fix, "format")).find(|format| format.is_object()).expect("a format");
    let mended = api::check(&get(&preset, "source"), &format, &JsValue::UNDEFINED).expect("no malformed argument");
    assert_eq!(rules_of(&mended, "error"), [""; 0]);

    let edits = fixes.iter().map(|fix| get(fix, "edits")).find(|edits| edits.is_object()).expect("edits");
    let mut source: Vec<u16> = text(&preset, "source").encode_utf16().collect();
    for edit in Array::from(&edits).iter().collect::<Vec<_>>().into_iter().rev() {
        let (from, to) = (number(&edit, "from") as usize, number(&edit, "to") as usize);
        source.splice(from..to, text(&edit, "insert").encode_utf16());
    }
    let source = String::from_utf16(&source).expect("UTF-16");
    let mended = api::check(&source.into(), &get(&preset, "format"), &JsValue::UNDEFINED).expect("an object");
    // The block with the mended signs is no longer among them.
    assert_eq!(rules_of(&mended, "error"), ["MOT-05"; 2]);
}

#[wasm_bindgen_test]
fn offsets_are_utf_16_code_units_and_lines_count_from_one() {
    let format = get(&preset("annex-e-circular"), "format");
    let source = "%\r\n(\u{1F600}) N001 G01 \u{2212}\r\n";
    let report = api::check(&source.into(), &format, &JsValue::UNDEFINED).expect("no malformed argument");
    let found = list(&report, "diagnostics");
    let found = found.iter().find(|found| text(found, "message").contains("U+2212")).expect("a finding");
    assert_eq!((number(found, "from"), number(found, "to")), (17.0, 18.0));
    assert_eq!((number(found, "line"), number(found, "column")), (2.0, 15.0));
}

#[wasm_bindgen_test]
fn a_malformed_argument_throws_a_type_error_with_its_field() {
    let good = get(&preset("annex-e-circular"), "format");
    let source = JsValue::from("N001");
    let field = |result: Result<JsValue, JsValue>| {
        let error = result.expect_err("a TypeError");
        assert!(error.is_instance_of::<js_sys::TypeError>());
        text(&error, "field")
    };
    assert_eq!(field(api::check(&1.into(), &good, &JsValue::UNDEFINED)), "source");
    assert_eq!(field(api::check(&source, &"N3".into(), &JsValue::UNDEFINED)), "format");
    assert_eq!(field(api::check(&source, &Object::new().into(), &JsValue::UNDEFINED)), "standard");
    for tolerance in [JsValue::from(0.0), JsValue::from(-1.0), JsValue::from(f64::NAN), JsValue::NULL, "1".into()] {
        assert_eq!(field(api::points(&source, &good, &tolerance)), "tolerance");
    }
}

#[wasm_bindgen_test]
fn an_unknown_or_unusable_field_of_a_format_is_reported_not_thrown() {
    let preset = preset("annex-e-circular");
    let itemized = get(&preset, "format.itemized");
    Reflect::set(&itemized, &"feeed".into(), &1.into()).expect("an object");
    Reflect::set(&itemized, &"plane".into(), &"xz".into()).expect("an object");
    let explained = api::explain_format(&get(&preset, "format")).expect("no malformed argument");
    let paths: Vec<String> = list(&explained, "diagnostics").iter().map(|found| text(found, "path")).collect();
    assert!(paths.contains(&"itemized.feeed".to_owned()) && paths.contains(&"itemized.plane".to_owned()), "{paths:?}");
    assert_eq!(rules_of(&check(&preset), "error"), [""; 0]);
}

#[wasm_bindgen_test]
fn points_are_flat_arrays_and_end_on_the_programmed_point() {
    let preset = preset("annex-e-circular");
    let points =
        api::points(&get(&preset, "source"), &get(&preset, "format"), &0.01.into()).expect("no malformed argument");
    let xyz: Float64Array = get(&points, "xyz").unchecked_into();
    let span: Uint32Array = get(&points, "span").unchecked_into();
    assert_eq!(xyz.length(), 3 * span.length());
    let end: Vec<f64> = (0..3).map(|axis| xyz.get_index(xyz.length() - 3 + axis)).collect();
    assert_eq!(end, [10.0, 10.0, 20.0]);
    // 13 chords for each arc of 45 degrees and radius 20 within 0,01; two ends for each of the 8 lines.
    assert_eq!(span.length(), 3 * 14 + 8 * 2);
}

#[wasm_bindgen_test]
fn a_live_tape_answers_edits_like_a_fresh_check() {
    let preset = preset("annex-e-circular");
    let source = text(&preset, "source");
    let mut tape =
        api::Tape::new(&get(&preset, "source"), &get(&preset, "format"), &JsValue::UNDEFINED).expect("a tape");
    let at = source.find("F0042").expect("the word") as u32;
    assert_eq!(tape.edit(at, at + 5, "F0000"), 1);
    let summary = tape.summary();
    assert_eq!(number(&summary, "edit"), 1.0);
    assert_eq!(number(&summary, "errors"), 1.0);
    let found: Vec<JsValue> = tape.diagnostics(0, u32::MAX, 1000).unchecked_into::<Array>().to_vec();
    assert!(found.iter().any(|found| text(found, "rule") == "FEED-13"));
    let block = tape.block(tape.block_at(at) as u32);
    assert_eq!(text(&block, "sequence"), "N003");
}

#[wasm_bindgen_test]
fn registers_and_course_as_a_script_gets_them() {
    let preset = preset("annex-d-boring");
    let tape = api::Tape::new(&get(&preset, "source"), &get(&preset, "format"), &JsValue::UNDEFINED).expect("a tape");
    // N002, with an arithmetic code of 300 revolutions.
    let held = tape.registers(1);
    assert_eq!((text(&held, "fate"), text(&held, "sequence")), ("executed".to_owned(), "N002".to_owned()));
    assert_eq!((text(&held, "speed.word"), number(&held, "speed.perMinute")), ("S630".to_owned(), 300.0));
    assert_eq!((text(&held, "spindle.turns"), text(&held, "spindle.code")), ("clockwise".to_owned(), "M03".to_owned()));
    assert_eq!((text(&held, "tool.word"), text(&held, "tool.change.code")), ("T01".to_owned(), "M06".to_owned()));
    let motion = &list(&held, "modal")[0];
    assert_eq!((text(motion, "group"), text(motion, "code")), ("Motion".to_owned(), "G00".to_owned()));
    assert_eq!(list(&held, "position").len(), list(&tape.summary(), "axes").len());
    assert!(get(&held, "feed").is_null() && get(&held, "coolant").is_null());
    assert!(tape.registers(99).is_null());

    let course = tape.course();
    let rows: Uint32Array = get(&course, "rows").unchecked_into();
    // The program start, its end of block, then N001, G00, T01, M06 with six tabs and the end of block.
    assert_eq!((rows.get_index(0), rows.get_index(1)), (2, 2 + 4 + 1 + 3 + 7 + 3 + 1 + 3 + 1));
    let stops: js_sys::Uint8Array = get(&course, "stops").unchecked_into();
    assert_eq!(stops.to_vec(), [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2]);
    let ends: Uint32Array = get(&course, "spanEnds").unchecked_into();
    assert_eq!(f64::from(ends.get_index(15)), number(&tape.summary(), "spans"));
}

/// Letters, digits, signs, line ends, comments and rubbish, in the mixture that a spoiled tape has. The generator is
/// xorshift64 (Marsaglia, 2003): the same texts in every run.
struct Rubbish(u64);

impl Rubbish {
    fn next(&mut self, below: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % below
    }

    fn text(&mut self) -> String {
        const PIECES: [&str; 40] = [
            "N001",
            "G01",
            "G02",
            "G03",
            "G06",
            "G90",
            "G91",
            "G18",
            "X+010000",
            "Y-005000",
            "Z+1",
            "I+014142",
            "J-014142",
            "K+000001",
            "F0300",
            "M02",
            "M30",
            "S1",
            "T99",
            "\n",
            "\r\n",
            "\r",
            "*",
            "*\n",
            "(",
            ")",
            "%",
            "/",
            ":",
            "\t",
            " ",
            ".",
            "+",
            "-",
            "\u{0}",
            "\u{7F}",
            "\u{2212}",
            "\u{1F600}",
            "\u{FEFF}",
            "99999999999999999999",
        ];
        (0..self.next(120)).map(|_| PIECES[self.next(PIECES.len())]).collect()
    }
}

#[wasm_bindgen_test]
fn no_text_and_no_format_makes_any_function_fail() {
    let mut rubbish = Rubbish(0x2539_1058_0274);
    let formats: Vec<JsValue> = Array::from(&api::presets()).iter().map(|preset| get(&preset, "format")).collect();
    for round in 0..300 {
        let source = rubbish.text();
        let units = source.encode_utf16().count() as f64;
        let format: JsValue = Object::assign(&Object::new(), formats[round % formats.len()].unchecked_ref()).into();
        if round % 3 == 0 {
            for field in ["detail", "classification"] {
                Reflect::set(&format, &field.into(), &rubbish.text().into()).expect("an object");
            }
        }
        let inside = |found: &JsValue, end: f64| {
            let (from, to) = (number(found, "from"), number(found, "to"));
            assert!(0.0 <= from && from <= to && to <= end, "{from}..{to} of {end} in {source:?}");
        };
        let js_source = JsValue::from(source.as_str());
        let report = api::check(&js_source, &format, &JsValue::UNDEFINED).expect("no malformed argument");
        for found in list(&report, "diagnostics") {
            inside(&found, units);
            if get(&found, "fixes").is_object() {
                let edits = list(&found, "fixes").into_iter().map(|fix| get(&fix, "edits"));
                edits.filter(JsValue::is_object).for_each(|edits| {
                    Array::from(&edits).iter().for_each(|edit| inside(&edit, units));
                });
            }
        }
        list(&report, "blocks").iter().for_each(|block| inside(block, units));
        let explained = api::explain_format(&format).expect("no malformed argument");
        for found in list(&explained, "diagnostics") {
            let field = get(&format, &text(&found, "path")).as_string().unwrap_or_default();
            inside(&found, field.encode_utf16().count() as f64);
        }
        let rows = api::encode(&js_source, &format).expect("no malformed argument");
        assert_eq!(rows.len() as f64, number(&report, "totals.rows"));
        for found in Array::from(&api::suggest_format(&js_source).expect("a text")) {
            api::check(&js_source, &get(&found, "format"), &JsValue::UNDEFINED).expect("a format");
        }
        let decoded =
            api::decode(&js_sys::Uint8Array::from(rows.as_slice()).into(), &JsValue::UNDEFINED).expect("rows");
        let decoded_units = text(&decoded, "text").encode_utf16().count() as f64;
        list(&decoded, "issues").iter().for_each(|issue| inside(issue, decoded_units));
        let points = api::points(&js_source, &format, &0.1.into()).expect("no malformed argument");
        let xyz: Float64Array = get(&points, "xyz").unchecked_into();
        assert!(xyz.to_vec().iter().all(|coordinate| coordinate.is_finite()));

        let mut tape = api::Tape::new(&js_source, &format, &JsValue::UNDEFINED).expect("a tape");
        let (from, to) = (rubbish.next(60) as u32, rubbish.next(120) as u32);
        tape.edit(from, to, &rubbish.text());
        let summary = tape.summary();
        tape.rows(0, u32::MAX);
        tape.path(&0.1.into()).expect("no malformed argument");
        (0..number(&summary, "blocks") as u32).for_each(|index| drop(tape.block(index)));
        (0..number(&summary, "spans") as u32).for_each(|index| drop(tape.span(index)));
        let held = Array::from(&tape.registers_of(0, u32::MAX));
        assert_eq!(held.length() as f64, number(&summary, "blocks"));
        let seconds: Float64Array = get(&tape.course(), "seconds").unchecked_into();
        assert_eq!(seconds.length(), held.length());
        assert!(seconds.to_vec().iter().all(|seconds| seconds.is_finite() && *seconds >= 0.0));
    }
}

#[wasm_bindgen_test]
fn after_each_of_a_thousand_edits_a_tape_equals_a_fresh_one() {
    for seed in 0..20 {
        edits::edited(seed, 50, &edits::tape(30));
    }
}

/// All that the interface tells of a live tape, but for the number of its edit.
fn told(tape: &mut api::Tape) -> String {
    let summary = tape.summary();
    let blocks = number(&summary, "blocks") as u32;
    let tolerance = JsValue::from(0.01);
    let parts = Array::of4(
        &Array::from_iter((0..blocks).map(|index| tape.block(index))),
        &tape.diagnostics(0, u32::MAX, u32::MAX),
        &tape.rows(0, u32::MAX),
        &tape.path(&tolerance).expect("a tolerance"),
    );
    Reflect::set(&summary, &"edit".into(), &JsValue::NULL).expect("an object");
    parts.push(&summary);
    js_sys::JSON::stringify(&parts).expect("plain values").into()
}

#[wasm_bindgen_test]
fn edits_count_in_code_units_even_between_the_halves_of_a_pair() {
    let format = get(&preset("annex-e-circular"), "format");
    let open = |text: &js_sys::JsString| api::Tape::new(text, &format, &JsValue::UNDEFINED).expect("a format");
    let mut numbers = edits::Numbers::new(16);
    let mut text = js_sys::JsString::from(edits::tape(20));
    let mut tape = open(&text);
    for turn in 0..200 {
        let (from, to, insert) = edits::edit(&mut numbers, text.length() as usize);
        let (from, to) = (from as u32, to as u32);
        tape.edit(from, to, insert);
        text = text.slice(0, from).concat(&insert.into()).concat(&text.slice(to, text.length()));
        // What is left of a pair is U+FFFD, here and there.
        text = String::from_utf16_lossy(&text.iter().collect::<Vec<u16>>()).into();
        assert_eq!(told(&mut tape), told(&mut open(&text)), "turn {turn}");
    }
}
