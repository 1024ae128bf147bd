//! `cargo xtask build`: the npm package in `pkg/`, the static site in `dist/`.

use std::fs;
use std::process::ExitCode;

use crate::Trouble;
use crate::run::{run, say};
use crate::tools::{npm, wasm_pack};
use crate::workspace::Workspace;

/// The files that npm would leave out of a published package unless they are listed.
const LICENCES: [&str; 2] = ["LICENSE-MIT", "LICENSE-APACHE"];

const README: &str = include_str!("../../package-readme.md");

/// Builds both.
pub fn command(workspace: &Workspace, args: &[String]) -> Result<ExitCode, Trouble> {
    if let Some(unknown) = args.first() {
        return Err(format!("`build` takes no argument, and was given `{unknown}`."));
    }
    both(workspace)?;
    say("The npm package is in pkg/, the site in dist/.");
    Ok(ExitCode::SUCCESS)
}

/// The npm package, then the site that contains it.
pub fn both(workspace: &Workspace) -> Result<(), Trouble> {
    package(workspace)?;
    site(workspace)
}

/// The npm package.
pub fn package(workspace: &Workspace) -> Result<(), Trouble> {
    let mut wasm_pack = wasm_pack::command(workspace)?;
    let pkg = workspace.pkg();
    // Otherwise wasm-pack keeps what it does not know, and the list of files would grow each time.
    if pkg.exists() {
        fs::remove_dir_all(&pkg).map_err(|e| format!("the old {} cannot be removed: {e}.", pkg.display()))?;
    }
    run(wasm_pack.args([
        "build",
        "crates/nctape-wasm",
        "--target",
        "web",
        "--release",
        "--out-dir",
        "../../pkg",
        "--out-name",
        "nctape",
        "--mode",
        "no-install",
    ]))?;
    // wasm-pack names the package after the crate.
    let mut set = npm::npm(&pkg);
    set.args(["pkg", "set", "name=nctape"]);
    for licence in LICENCES {
        set.arg(format!("files[]={licence}"));
        fs::copy(workspace.path(licence), pkg.join(licence))
            .map_err(|e| format!("{licence} cannot be copied to pkg/: {e}."))?;
    }
    fs::write(pkg.join("README.md"), README).map_err(|e| format!("pkg/README.md cannot be written: {e}."))?;
    run(&mut set)
}

/// The static site, from a package that is built.
pub fn site(workspace: &Workspace) -> Result<(), Trouble> {
    npm::ensure(workspace)?;
    run(npm::node(workspace).arg("node_modules/vite/bin/vite.js").arg("build"))
}
