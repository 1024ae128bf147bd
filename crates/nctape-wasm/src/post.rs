//! The post-processor as a script sees it.

use crate::argument::{self, malformed};
use crate::cldata::reading;
use crate::convert::converted;
use crate::value::from_js;
use nctape::format::value::Value;
use nctape::post::{self, Arcs, Options};
use wasm_bindgen::prelude::*;

/// The tape of a format that does what CLDATA says: the reference language of ISO 3592, or the CL text of a CAM system.
#[wasm_bindgen(js_name = postprocess, unchecked_return_type = "Converted")]
pub fn postprocess(
    #[wasm_bindgen(unchecked_param_type = "string")] cldata: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PostOptions | null")] options: &JsValue,
) -> Result<JsValue, JsValue> {
    let cldata = argument::text(cldata, "cldata")?;
    let (format, _) = argument::format(format)?;
    let options = posting(options)?;
    Ok(converted(post::postprocess_with(&cldata, &format, &options), &cldata, format.standard))
}

/// How the text is read and posted.
fn posting(options: &JsValue) -> Result<Options, JsValue> {
    let mut posting = Options { reading: reading(options)?, ..Options::default() };
    if options.is_undefined() || options.is_null() {
        return Ok(posting);
    }
    let options = from_js(options);
    if !matches!(options, Value::Map(_)) {
        return Err(malformed("options", "a set of fields is wanted"));
    }
    posting.arcs = match options.get("arcs") {
        None => None,
        Some(Value::Text(word)) if Arcs::from_word(word).is_some() => Arcs::from_word(word),
        Some(_) => {
            let words: Vec<&str> = Arcs::ALL.iter().map(|choice| choice.1).collect();
            return Err(malformed("arcs", &format!("one of {} is wanted", words.join(", "))));
        }
    };
    posting.quadrants = match options.get("quadrants") {
        None => false,
        Some(Value::Flag(flag)) => *flag,
        Some(_) => return Err(malformed("quadrants", "true or false is wanted")),
    };
    posting.tolerance = match options.get("tolerance") {
        None => None,
        Some(Value::Number(number)) if number.is_finite() && *number > 0.0 => Some(*number),
        Some(_) => return Err(malformed("tolerance", "a number above 0 is wanted")),
    };
    Ok(posting)
}
