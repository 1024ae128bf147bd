//! A path as typed arrays: of a tape or of CLDATA, it is drawn by the same means.

use crate::functions::{points_to_js, set};
use nctape::flatten::Points;
use nctape::span::Span;

/// Some spans with what drawing needs. The points count their spans as in the whole path.
pub(crate) fn path_to_js(spans: &[Span], points: &Points) -> js_sys::Object {
    let object = points_to_js(points);
    let kinds: Vec<u8> = spans.iter().map(|span| span.kind.index() as u8 + 1).collect();
    let substitutes: Vec<u8> = spans.iter().map(|span| u8::from(span.substitute)).collect();
    let blocks: Vec<u32> = spans.iter().flat_map(|span| [span.blocks.0 as u32, span.blocks.1 as u32]).collect();
    set(&object, "kinds", &js_sys::Uint8Array::from(kinds.as_slice()));
    set(&object, "substitutes", &js_sys::Uint8Array::from(substitutes.as_slice()));
    set(&object, "blocks", &js_sys::Uint32Array::from(blocks.as_slice()));
    object
}

/// The same as what has changed of a path: so many spans at either end are kept.
pub(crate) fn change_to_js(object: &js_sys::Object, number: u32, kept: [usize; 2], shift: f64) {
    set(object, "number", &number.into());
    set(object, "first", &(kept[0] as u32).into());
    set(object, "last", &(kept[1] as u32).into());
    set(object, "shift", &shift.into());
}
