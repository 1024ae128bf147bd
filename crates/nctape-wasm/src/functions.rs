//! The functions that take a text and a format and answer at once.

use crate::argument;
use crate::offsets::Offsets;
use crate::report::{self, API, DiagnosticView, ReportView};
use crate::value::{Plain, to_js};
use nctape::Tape;
use nctape::code;
use nctape::flatten::Points;
use nctape::format::{Classification, Control, FormatDiagnostic, Sign, Zeros, explain_read, one_line};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[derive(Serialize)]
struct Version {
    package: &'static str,
    api: u32,
}

/// The version of the package and of the interface.
#[wasm_bindgen(unchecked_return_type = "{ package: string, api: 1 }")]
pub fn version() -> JsValue {
    to_js(&Version { package: env!("CARGO_PKG_VERSION"), api: API })
}

/// Reads, executes and checks a tape.
#[wasm_bindgen(unchecked_return_type = "Report")]
pub fn check(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "CheckOptions | null")] options: &JsValue,
) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let (format, _) = argument::format(format)?;
    let options = argument::options(options)?;
    let tape = Tape::with_skip(&source, &format, options.skip);
    let offsets = Offsets::new(&source);
    let found = tape.diagnostics();
    let shown = &found[..found.len().min(options.limit)];
    let blocks = &tape.reading().blocks[..if options.blocks { tape.reading().blocks.len() } else { 0 }];
    let spans = if options.spans { tape.spans().list.len() } else { 0 };
    Ok(to_js(&ReportView {
        api: API,
        unit: tape.control().unit.name(),
        axes: report::axes(&tape),
        diagnostics: shown.iter().map(|found| report::diagnostic(found, tape.standard(), &offsets)).collect(),
        suppressed: found.len() - shown.len(),
        blocks: blocks.iter().map(|block| report::block(&tape, block, &offsets)).collect(),
        spans: (0..spans).map(|index| report::span(&tape, index)).collect(),
        totals: report::totals(&tape),
    }))
}

#[derive(Serialize)]
struct Explained {
    classification: Option<ClassificationView>,
    detail: Option<DetailView>,
    sentences: Vec<String>,
    diagnostics: Vec<DiagnosticView>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct ClassificationView {
    text: String,
    system: Option<String>,
    unit: Option<&'static str>,
    angles: Option<&'static str>,
    motions: Option<u8>,
    dimension_motions: Option<u8>,
    simultaneous_motions: Option<u8>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct DetailView {
    words: Vec<DesignationView>,
    ends_with_asterisk: bool,
}

#[derive(Serialize)]
struct DesignationView {
    address: String,
    from: usize,
    to: usize,
    tab: bool,
    dimension: bool,
    sign: Option<&'static str>,
    before: u8,
    after: u8,
    zeros: &'static str,
}

/// A format in words, and what is wrong with it. Rules of the family SPEC are reported here, never by `check`.
#[wasm_bindgen(js_name = explainFormat, unchecked_return_type = "FormatExplanation")]
pub fn explain_format(#[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue) -> Result<JsValue, JsValue> {
    let (format, problems) = argument::format(format)?;
    let explanation = explain_read(&format, &problems);
    Ok(to_js(&Explained {
        classification: format.classification.as_ref().map(|text| classification(text, &explanation.control)),
        detail: Some(detail(&explanation.control)).filter(|detail| !detail.words.is_empty()),
        sentences: explanation.sentences.clone(),
        diagnostics: explanation.diagnostics.iter().map(|found| format_diagnostic(found, &format)).collect(),
    }))
}

fn classification(text: &str, control: &Control) -> ClassificationView {
    let found = control.classification.as_ref();
    let digit = |index: usize| found.and_then(Classification::digits).map(|digits| digits[index]);
    ClassificationView {
        text: text.to_owned(),
        system: found.and_then(Classification::system).map(|system| system.letter().to_string()),
        unit: found.and_then(Classification::unit).map(|unit| unit.name()),
        angles: found.and_then(Classification::angles).map(|angles| match angles {
            nctape::format::Angles::Turns => "turns",
            nctape::format::Angles::Degrees => "degrees",
        }),
        motions: digit(0),
        dimension_motions: digit(1),
        simultaneous_motions: digit(2),
    }
}

fn detail(control: &Control) -> DetailView {
    let offsets = Offsets::new(&control.format.detail);
    let words = control.detail.words.iter().map(|word| DesignationView {
        address: word.address.to_string(),
        from: offsets.utf16(word.range.start),
        to: offsets.utf16(word.range.end),
        tab: word.tab,
        dimension: word.dimension,
        sign: word.dimension.then_some(match word.sign {
            Sign::Positive => "absolute-positive",
            Sign::Signed => "absolute",
            Sign::Incremental => "incremental",
            Sign::Both => "both",
        }),
        before: word.before,
        after: word.after,
        zeros: match word.zeros {
            Zeros::All => "all",
            Zeros::LeadingOmitted => "leading-omitted",
            Zeros::TrailingOmitted => "trailing-omitted",
        },
    });
    DetailView { words: words.collect(), ends_with_asterisk: control.detail.end.is_some() }
}

fn format_diagnostic(found: &FormatDiagnostic, format: &nctape::Format) -> DiagnosticView {
    let mut view = report::diagnostic(&found.diagnostic, format.standard, &Offsets::new(&found.text));
    view.path = Some(found.path.clone());
    view
}

/// A format in one line.
#[wasm_bindgen(js_name = formatLine)]
pub fn format_line(#[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue) -> Result<String, JsValue> {
    Ok(one_line(&argument::format(format)?.0))
}

#[derive(Serialize)]
struct SuggestionView {
    format: Plain,
    sure: Vec<String>,
    assumed: Vec<String>,
    errors: usize,
}

/// Formats that fit a listing that came without one, best first.
#[wasm_bindgen(js_name = suggestFormat, unchecked_return_type = "Suggestion[]")]
pub fn suggest_format(#[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let views = nctape::suggest(&source).into_iter().map(|found| SuggestionView {
        format: Plain(found.format.write()),
        sure: found.sure,
        assumed: found.assumed,
        errors: found.errors,
    });
    Ok(to_js(&views.collect::<Vec<_>>()))
}

#[derive(Serialize)]
struct PlacesView {
    places: u8,
    least: u8,
    greatest: u8,
}

/// Decimal places of a format's dimension words, and how far they can be moved; `null` where it has none.
#[wasm_bindgen(
    js_name = decimalPlaces,
    unchecked_return_type = "{ places: number, least: number, greatest: number } | null"
)]
pub fn decimal_places(#[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue) -> Result<JsValue, JsValue> {
    let places = nctape::format::Places::of(&argument::format(format)?.0);
    let view = places.map(|found| PlacesView { places: found.places, least: found.least, greatest: found.greatest });
    Ok(to_js(&view))
}

/// The format with the decimal sign of all dimension words moved together, so that the first has `places` behind it;
/// `null` where a word has not the digits for it.
#[wasm_bindgen(js_name = shiftDecimals, unchecked_return_type = "Format | null")]
pub fn shift_decimals(
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    places: f64,
) -> Result<JsValue, JsValue> {
    let (format, _) = argument::format(format)?;
    // `as` saturates: what is no count of places is beyond what any word allows.
    let moved = if places >= 0.0 { format.with_places(places as u8) } else { None };
    Ok(to_js(&moved.map(|format| Plain(format.write()))))
}

/// The rows of a tape: one byte a row, track n is bit n-1.
#[wasm_bindgen]
pub fn encode(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
) -> Result<Vec<u8>, JsValue> {
    let source = argument::text(source, "source")?;
    let control = Control::new(&argument::format(format)?.0);
    Ok(code::encode(&source, control.code, control.end_of_block).bytes)
}

#[derive(Serialize)]
pub(crate) struct DecodedView {
    text: String,
    code: &'static str,
    reason: String,
    issues: Vec<IssueView>,
}

#[derive(Serialize)]
struct IssueView {
    row: usize,
    byte: u8,
    rule: &'static str,
    kind: &'static str,
    message: String,
    from: usize,
    to: usize,
}

/// The listing of a tape, the code that it is in, and what is wrong with its rows.
#[wasm_bindgen(unchecked_return_type = "Decoded")]
pub fn decode(
    #[wasm_bindgen(unchecked_param_type = "Uint8Array")] rows: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "DecodeOptions | null")] options: &JsValue,
) -> Result<JsValue, JsValue> {
    let rows = argument::bytes(rows, "rows")?;
    Ok(to_js(&decoded(&code::decode(&rows, argument::decode_options(options)?))))
}

/// What a tape says, as a script sees it.
pub(crate) fn decoded(decoded: &code::Decoded) -> DecodedView {
    let offsets = Offsets::new(&decoded.text);
    let issues = decoded.issues.iter().map(|issue| IssueView {
        row: issue.row,
        byte: issue.byte,
        rule: issue.kind.rule().id(),
        kind: issue.kind.name(),
        message: issue.message.clone(),
        from: offsets.utf16(issue.range.start),
        to: offsets.utf16(issue.range.end),
    });
    DecodedView {
        code: argument::code_word(decoded.code),
        reason: decoded.reason.clone(),
        issues: issues.collect(),
        text: decoded.text.clone(),
    }
}

/// The path as points within a tolerance, a length above zero in the unit of the format.
#[wasm_bindgen(unchecked_return_type = "Points")]
pub fn points(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] tolerance: &JsValue,
) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let (format, _) = argument::format(format)?;
    let tolerance = argument::tolerance(tolerance)?;
    Ok(points_to_js(&Tape::new(&source, &format).points(tolerance)).into())
}

/// Points as typed arrays.
pub(crate) fn points_to_js(points: &Points) -> js_sys::Object {
    let object = js_sys::Object::new();
    set(&object, "xyz", &js_sys::Float64Array::from(points.xyz.as_slice()));
    set(&object, "span", &js_sys::Uint32Array::from(points.span.as_slice()));
    object
}

/// Sets a property of a fresh object, which cannot fail.
pub(crate) fn set(object: &js_sys::Object, name: &str, value: &JsValue) {
    let _ = js_sys::Reflect::set(object, &name.into(), value);
}

/// The 256 columns of tape for a pitch in device pixels, "light" or "dark", as one sheet.
#[wasm_bindgen(
    unchecked_return_type = "{ image: ImageData, pitch: number, columnHeight: number, paperTop: number, paperHeight: number, perRow: number, bench: string, paper: string }"
)]
pub fn columns(
    pitch: f64,
    #[wasm_bindgen(unchecked_param_type = "\"light\" | \"dark\"")] theme: &JsValue,
) -> Result<JsValue, JsValue> {
    let theme = argument::theme(theme)?;
    // `as` saturates, and a pitch that is no number becomes 0: the columns clamp it to what they can draw.
    let columns = nctape_draw::Columns::new(pitch as u32, theme);
    let sheet = columns.sheet();
    let image = web_sys::ImageData::new_with_u8_clamped_array_and_sh(
        wasm_bindgen::Clamped(&sheet.rgba),
        sheet.width,
        sheet.height,
    )?;
    let object = js_sys::Object::new();
    let css = |[red, green, blue]: nctape_draw::Rgb| JsValue::from(format!("#{red:02x}{green:02x}{blue:02x}"));
    set(&object, "image", &image);
    set(&object, "pitch", &columns.pitch().into());
    set(&object, "columnHeight", &columns.height().into());
    set(&object, "paperTop", &columns.paper_top().into());
    set(&object, "paperHeight", &columns.paper_height().into());
    set(&object, "perRow", &(sheet.width / columns.pitch()).into());
    set(&object, "bench", &css(theme.colours().bench));
    set(&object, "paper", &css(theme.colours().paper));
    Ok(object.into())
}
