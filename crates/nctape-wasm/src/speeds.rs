//! Codes of feeds and speeds, both ways, and the time of a tape with its reader.

use crate::argument::{self, malformed};
use crate::functions::set;
use crate::live::Tape;
use crate::value::{from_js, to_js};
use nctape::format::value::Value;
use nctape::format::{Control, Unit};
use nctape::speed::{Compared, Comparison};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct ComparisonView {
    unit: &'static str,
    length_unit: &'static str,
    rows: Vec<ComparedView>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct ComparedView {
    method: &'static str,
    title: String,
    clause: &'static str,
    in_force: bool,
    code: Option<String>,
    speed: Option<f64>,
    deviation: Option<f64>,
    rapid: bool,
    note: String,
}

/// The code of a speed by each method of annex A.
#[wasm_bindgen(js_name = speedCodes, unchecked_return_type = "SpeedComparison")]
pub fn speed_codes(
    speed: f64,
    #[wasm_bindgen(unchecked_param_type = "SpeedQuery")] about: &JsValue,
) -> Result<JsValue, JsValue> {
    let (comparison, length_unit) = comparison(about)?;
    Ok(to_js(&view(&comparison, length_unit, comparison.codes(speed))))
}

/// What each method of annex A reads in a code; `null` where it is no row of digits.
#[wasm_bindgen(js_name = speedOf, unchecked_return_type = "SpeedComparison | null")]
pub fn speed_of(
    #[wasm_bindgen(unchecked_param_type = "string")] code: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "SpeedQuery")] about: &JsValue,
) -> Result<JsValue, JsValue> {
    let code = argument::text(code, "code")?;
    let (comparison, length_unit) = comparison(about)?;
    let rows = comparison.speeds(&code);
    Ok(rows.map_or(JsValue::NULL, |rows| to_js(&view(&comparison, length_unit, rows))))
}

fn comparison(about: &JsValue) -> Result<(Comparison, &'static str), JsValue> {
    let format = js_sys::Reflect::get(about, &"format".into()).unwrap_or(JsValue::UNDEFINED);
    let control = Control::new(&argument::format(&format)?.0);
    let about = from_js(about);
    let feed = match about.get("address") {
        None => true,
        Some(Value::Text(address)) if address == "F" => true,
        Some(Value::Text(address)) if address == "S" => false,
        Some(_) => return Err(malformed("address", "\"F\" or \"S\" is wanted")),
    };
    let measure = |field: &str| match about.get(field) {
        None | Some(Value::Null) => Ok(None),
        Some(Value::Number(number)) => Ok(Some(*number)),
        Some(_) => Err(malformed(field, "a number is wanted")),
    };
    let length_unit = if control.unit == Unit::Inch { "inch" } else { "mm" };
    let mut comparison = Comparison::new(control, feed);
    comparison.length = measure("length")?;
    comparison.radius = measure("radius")?;
    Ok((comparison, length_unit))
}

fn view(comparison: &Comparison, length_unit: &'static str, rows: Vec<Compared>) -> ComparisonView {
    let rows = rows.into_iter().map(|row| ComparedView {
        method: row.method.word(),
        title: row.title,
        clause: row.clause,
        in_force: row.in_force,
        code: row.code,
        speed: row.speed,
        deviation: row.deviation,
        rapid: row.rapid,
        note: row.note,
    });
    ComparisonView { unit: comparison.unit(), length_unit, rows: rows.collect() }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct TimeView {
    reading: f64,
    executing: Option<f64>,
    buffered: Option<f64>,
    unbuffered: Option<f64>,
    starved: usize,
    waiting: f64,
    leading_zeros: usize,
    trailing_zeros: usize,
    permitted_zeros: usize,
    sentences: Vec<String>,
}

#[wasm_bindgen]
impl Tape {
    /// How long some blocks take to execute and to read, from a block on.
    #[wasm_bindgen(unchecked_return_type = "BlockTimes")]
    pub fn times(&self, first: u32, count: u32) -> JsValue {
        let first = first as usize;
        let times = self.tape.times(first..first.saturating_add(count as usize));
        let executing: Vec<f64> = times.executing.iter().map(|seconds| seconds.unwrap_or(-1.0)).collect();
        let starved: Vec<u8> = times.starved.iter().map(|&starved| starved.into()).collect();
        let object = js_sys::Object::new();
        set(&object, "executing", &js_sys::Float64Array::from(executing.as_slice()));
        set(&object, "reading", &js_sys::Float64Array::from(times.reading.as_slice()));
        set(&object, "starved", &js_sys::Uint8Array::from(starved.as_slice()));
        object.into()
    }

    /// How long the tape takes with its reader, in numbers and in words.
    #[wasm_bindgen(unchecked_return_type = "TapeTime")]
    pub fn time(&self) -> JsValue {
        let time = self.tape.time();
        to_js(&TimeView {
            reading: time.reading,
            executing: time.executing,
            buffered: time.buffered,
            unbuffered: time.unbuffered,
            starved: time.starved,
            waiting: time.waiting,
            leading_zeros: time.zeros.leading,
            trailing_zeros: time.zeros.trailing,
            permitted_zeros: time.zeros.permitted,
            sentences: time.sentences(&self.tape.control().format),
        })
    }
}
