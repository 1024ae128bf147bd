//! Arguments: what a script passes in, or a `TypeError` that names the field at fault.

use crate::value::from_js;
use nctape::Format;
use nctape::code::{Code, DecodeOptions};
use nctape::format::FormatDiagnostic;
use nctape::format::value::Value;
use wasm_bindgen::{JsCast, JsValue};

/// A `TypeError` with a property `field`.
pub(crate) fn malformed(field: &str, message: &str) -> JsValue {
    let error = js_sys::TypeError::new(&format!("{field}: {message}"));
    // Setting a property of a fresh object cannot fail.
    let _ = js_sys::Reflect::set(&error, &"field".into(), &field.into());
    error.into()
}

/// A text.
pub(crate) fn text(value: &JsValue, field: &str) -> Result<String, JsValue> {
    value.as_string().ok_or_else(|| malformed(field, "a string is wanted"))
}

/// A format, and what is wrong with it.
pub(crate) fn format(value: &JsValue) -> Result<(Format, Vec<FormatDiagnostic>), JsValue> {
    Format::read(&from_js(value)).map_err(|error| malformed(error.field, &error.message))
}

/// Bytes: a `Uint8Array`.
pub(crate) fn bytes(value: &JsValue, field: &str) -> Result<Vec<u8>, JsValue> {
    let bytes = value.dyn_ref::<js_sys::Uint8Array>();
    bytes.map(js_sys::Uint8Array::to_vec).ok_or_else(|| malformed(field, "a Uint8Array is wanted"))
}

/// A code of tape by its word, "iso" or "eia".
pub(crate) fn code(word: &str) -> Option<Code> {
    match word {
        "iso" => Some(Code::Iso),
        "eia" => Some(Code::Eia),
        _ => None,
    }
}

/// A theme of pictures by its word.
pub(crate) fn theme(value: &JsValue) -> Result<nctape_draw::Theme, JsValue> {
    match value.as_string().as_deref() {
        Some("light") => Ok(nctape_draw::Theme::Light),
        Some("dark") => Ok(nctape_draw::Theme::Dark),
        _ => Err(malformed("theme", "\"light\" or \"dark\" is wanted")),
    }
}

/// The word of a code.
pub(crate) fn code_word(code: Code) -> &'static str {
    match code {
        Code::Iso => "iso",
        Code::Eia => "eia",
    }
}

/// How rows are to be decoded; left out, the code is recognised and blocks are not counted.
pub(crate) fn decode_options(value: &JsValue) -> Result<DecodeOptions, JsValue> {
    let mut options = DecodeOptions::default();
    if value.is_undefined() || value.is_null() {
        return Ok(options);
    }
    let value = from_js(value);
    if !matches!(value, Value::Map(_)) {
        return Err(malformed("options", "a set of fields is wanted"));
    }
    match value.get("code") {
        None => {}
        Some(Value::Text(word)) if word == "auto" => {}
        Some(Value::Text(word)) if code(word).is_some() => options.code = code(word),
        Some(_) => return Err(malformed("code", "\"auto\", \"iso\" or \"eia\" is wanted")),
    }
    match value.get("countBlocks") {
        None => {}
        Some(Value::Flag(flag)) => options.count_blocks = *flag,
        Some(_) => return Err(malformed("countBlocks", "true or false is wanted")),
    }
    Ok(options)
}

/// A length above zero.
pub(crate) fn tolerance(value: &JsValue) -> Result<f64, JsValue> {
    value
        .as_f64()
        .filter(|number| number.is_finite() && *number > 0.0)
        .ok_or_else(|| malformed("tolerance", "a number above 0 is wanted"))
}

/// What a check is asked for.
pub(crate) struct Options {
    pub skip: bool,
    pub blocks: bool,
    pub spans: bool,
    pub limit: usize,
}

/// How many diagnostics are returned unless the script says otherwise: API.
const LIMIT: usize = 1000;

/// The options of a check; left out, each has its default.
pub(crate) fn options(value: &JsValue) -> Result<Options, JsValue> {
    let mut options = Options { skip: false, blocks: true, spans: true, limit: LIMIT };
    if value.is_undefined() || value.is_null() {
        return Ok(options);
    }
    let value = from_js(value);
    if !matches!(value, Value::Map(_)) {
        return Err(malformed("options", "a set of fields is wanted"));
    }
    let flag = |field: &str, default: bool| match value.get(field) {
        None => Ok(default),
        Some(Value::Flag(flag)) => Ok(*flag),
        Some(_) => Err(malformed(field, "true or false is wanted")),
    };
    options.skip = flag("skip", options.skip)?;
    options.blocks = flag("blocks", options.blocks)?;
    options.spans = flag("spans", options.spans)?;
    options.limit = match value.get("limit") {
        None => options.limit,
        Some(Value::Number(number)) if *number >= 0.0 => *number as usize,
        Some(_) => return Err(malformed("limit", "a number of at least 0 is wanted")),
    };
    Ok(options)
}
