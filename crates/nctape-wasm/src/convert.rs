//! Conversions: tapes to other languages of controls.

use crate::argument::{self, malformed};
use crate::offsets::Offsets;
use crate::report::{self, DiagnosticView};
use crate::value::to_js;
use nctape::convert::{self, Converted, Dialect};
use nctape::{Diagnostic, Standard};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[derive(Serialize)]
struct ConvertedView {
    text: String,
    diagnostics: Vec<DiagnosticView>,
    map: Vec<[usize; 4]>,
    /// Something of the source is lacking.
    #[serde(skip_serializing_if = "Option::is_none")]
    incomplete: Option<bool>,
}

/// Decimal G-code that does what a tape does, with the optional block skip switch off.
#[wasm_bindgen(js_name = toDecimal, unchecked_return_type = "Converted")]
pub fn to_decimal(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "\"linuxcnc\"")] dialect: &JsValue,
) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let (format, _) = argument::format(format)?;
    let dialect = dialect.as_string().as_deref().and_then(Dialect::from_word);
    let dialect = dialect.ok_or_else(|| malformed("dialect", &format!("{} is wanted", dialects())))?;
    Ok(converted(convert::to_decimal(&source, &format, dialect), &source, format.standard))
}

/// A tape of a format that does what decimal G-code does.
#[wasm_bindgen(js_name = fromDecimal, unchecked_return_type = "Converted")]
pub fn from_decimal(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] to: &JsValue,
) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let (to, _) = argument::format(to)?;
    Ok(converted(convert::from_decimal(&source, &to), &source, to.standard))
}

/// A tape of one format as a tape of another.
#[wasm_bindgen(js_name = convert, unchecked_return_type = "Converted")]
pub fn convert_tape(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] from: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] to: &JsValue,
) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let (from, _) = argument::format(from)?;
    let (to, _) = argument::format(to)?;
    Ok(converted(convert::convert(&source, &from, &to), &source, from.standard))
}

/// The words of the dialects, for a message.
fn dialects() -> String {
    let words: Vec<String> = Dialect::ALL.iter().map(|(_, word, _)| format!("\"{word}\"")).collect();
    words.join(" or ")
}

/// What a conversion gave, with offsets in UTF-16 code units on both sides.
pub(crate) fn converted(converted: Converted, source: &str, standard: Standard) -> JsValue {
    let (from, to) = (Offsets::new(source), Offsets::new(&converted.text));
    let diagnostic = |found: &Diagnostic| report::diagnostic(found, standard, &from);
    let map = converted.map.iter().map(|(source, text)| {
        [from.utf16(source.start), from.utf16(source.end), to.utf16(text.start), to.utf16(text.end)]
    });
    to_js(&ConvertedView {
        diagnostics: converted.diagnostics.iter().map(diagnostic).collect(),
        map: map.collect(),
        incomplete: converted.is_incomplete().then_some(true),
        text: converted.text,
    })
}
