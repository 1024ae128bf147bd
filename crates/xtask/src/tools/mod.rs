//! What the commands need, and how each of it is installed.

pub mod browser;
pub mod cache;
pub mod cargo_install;
pub mod npm;
pub mod rust;
pub mod wasm_bindgen;
pub mod wasm_pack;
