//! Plain values in and out of JavaScript.

use nctape::format::value::Value;
use serde::ser::{Serialize, SerializeMap, Serializer};
use wasm_bindgen::{JsCast, JsValue};

/// Formats are three levels deep; what lies deeper (or runs in a circle) is no format.
const DEEPEST: u32 = 8;

/// Takes a JavaScript value as a plain one. What has no plain value is taken as a text that names its type, so that a
/// message can say what was found.
pub(crate) fn from_js(value: &JsValue) -> Value {
    read(value, DEEPEST)
}

fn read(value: &JsValue, depth: u32) -> Value {
    if value.is_null() || value.is_undefined() {
        Value::Null
    } else if let Some(flag) = value.as_bool() {
        Value::Flag(flag)
    } else if let Some(number) = value.as_f64() {
        Value::Number(number)
    } else if let Some(text) = value.as_string() {
        Value::Text(text)
    } else if depth == 0 || !value.is_object() || value.is_function() {
        Value::Text(value.js_typeof().as_string().unwrap_or_default())
    } else if let Some(list) = value.dyn_ref::<js_sys::Array>() {
        Value::List(list.iter().map(|item| read(&item, depth - 1)).collect())
    } else {
        let entries = js_sys::Object::entries(value.unchecked_ref());
        let pair = |entry: JsValue| {
            let entry: js_sys::Array = entry.unchecked_into();
            Some((entry.get(0).as_string()?, read(&entry.get(1), depth - 1)))
        };
        Value::Map(entries.iter().filter_map(pair).collect())
    }
}

/// A plain value on its way to JavaScript.
pub(crate) struct Plain(pub Value);

impl Serialize for Plain {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        write(&self.0, serializer)
    }
}

fn write<S: Serializer>(value: &Value, serializer: S) -> Result<S::Ok, S::Error> {
    match value {
        Value::Null => serializer.serialize_unit(),
        Value::Flag(flag) => serializer.serialize_bool(*flag),
        Value::Number(number) => serializer.serialize_f64(*number),
        Value::Text(text) => serializer.serialize_str(text),
        Value::List(items) => serializer.collect_seq(items.iter().map(|item| Plain(item.clone()))),
        Value::Map(fields) => {
            let mut map = serializer.serialize_map(Some(fields.len()))?;
            for (name, value) in fields {
                map.serialize_entry(name, &Plain(value.clone()))?;
            }
            map.end()
        }
    }
}

/// Hands a value to JavaScript: maps as objects, nothing as `null`.
pub(crate) fn to_js<T: Serialize + ?Sized>(value: &T) -> JsValue {
    let serializer =
        serde_wasm_bindgen::Serializer::new().serialize_missing_as_null(true).serialize_maps_as_objects(true);
    // Only a map with keys that are no texts could fail; there are none.
    value.serialize(&serializer).unwrap_or(JsValue::NULL)
}
