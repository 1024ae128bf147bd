//! The JavaScript interface: the only crate that knows JavaScript.
//!
//! It converts byte offsets to UTF-16, plain values to JavaScript's, and lists to typed arrays; it decides nothing.
//! The types that a script sees are in `types.ts`.

mod argument;
mod cldata;
mod convert;
mod functions;
mod live;
mod offsets;
mod paper;
mod path;
mod post;
mod records;
mod replay;
mod report;
mod speeds;
mod value;
mod vocabulary;

use wasm_bindgen::prelude::wasm_bindgen;

// Rust sees the same names as a script, so that the browser tests can call them.
pub use cldata::{check_cldata, cl_text_to_cldata};
pub use convert::{convert_tape, from_decimal, to_decimal};
pub use functions::{
    check, columns, decimal_places, decode, encode, explain_format, format_line, points, shift_decimals,
    suggest_format, version,
};
pub use live::Tape;
pub use paper::{
    about_codes, lettering, lettering_note, on_machine_of, open_file, picture, reader_speed, row_words, why_untimed,
};
pub use post::postprocess;
pub use records::Cldata;
pub use speeds::{speed_codes, speed_of};
pub use vocabulary::{code_table, format_fields, presets, rules, span_kinds, standards};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.ts");
