//! wasm-pack, and what it in turn calls.

use std::process::Command;

use super::cargo_install::Program;
use super::{npm, rust, wasm_bindgen};
use crate::Trouble;
use crate::run::path_with;
use crate::version::Version;
use crate::workspace::Workspace;

/// The version with which every step here was tried; it is raised by hand.
const VERSION: Version = Version::new(0, 15, 1);

/// wasm-pack, ready to be called from the workspace root, with all that it needs on its PATH.
pub fn command(workspace: &Workspace) -> Result<Command, Trouble> {
    rust::ensure_target(workspace)?;
    let bindgen = wasm_bindgen::ensure(workspace)?;
    let pack = Program { package: "wasm-pack", version: VERSION, binary: "wasm-pack", locked: true }.ensure()?;
    // wasm-opt comes from the npm package `binaryen`; wasm-pack would download one otherwise.
    npm::ensure(workspace)?;
    let wasm_opt = workspace.path("node_modules/.bin");
    let mut command = Command::new(pack.join("wasm-pack"));
    command.current_dir(workspace.root()).env("PATH", path_with(&[bindgen, pack, wasm_opt])?);
    Ok(command)
}
