//! The parts of the Rust toolchain: rustup installs what `rust-toolchain.toml` lists together with
//! the toolchain, but adds nothing to a toolchain that is there already.

use std::path::Path;
use std::process::Command;

use crate::Trouble;
use crate::run::{find_program, output, run, say};
use crate::workspace::Workspace;

/// The target of the browser.
pub const WASM: &str = "wasm32-unknown-unknown";

/// Installs the standard library for the browser if it is missing.
pub fn ensure_target(workspace: &Workspace) -> Result<(), Trouble> {
    let mut sysroot = cargo_or_rustc(workspace, "rustc");
    sysroot.args(["--print", "sysroot"]);
    let sysroot = output(&mut sysroot).ok_or("`rustc` does not run. Install Rust by rustup.")?;
    let libraries = Path::new(sysroot.trim()).join("lib/rustlib").join(WASM);
    if libraries.join("lib").is_dir() {
        return Ok(());
    }
    say(&format!("Installing the Rust target {WASM}."));
    rustup(workspace, &["target", "add", WASM])
}

/// Installs rustfmt or clippy if it is missing.
pub fn ensure_component(workspace: &Workspace, component: &str) -> Result<(), Trouble> {
    let subcommand = if component == "rustfmt" { "fmt" } else { component };
    let mut version = cargo_or_rustc(workspace, "cargo");
    version.args([subcommand, "--version"]);
    if output(&mut version).is_some() {
        return Ok(());
    }
    say(&format!("Installing the Rust component {component}."));
    rustup(workspace, &["component", "add", component])
}

/// `cargo`, in the workspace.
pub fn cargo(workspace: &Workspace) -> Command {
    cargo_or_rustc(workspace, "cargo")
}

fn cargo_or_rustc(workspace: &Workspace, program: &str) -> Command {
    let mut command = Command::new(program);
    command.current_dir(workspace.root());
    command
}

fn rustup(workspace: &Workspace, args: &[&str]) -> Result<(), Trouble> {
    if find_program("rustup").is_none() {
        return Err(format!(
            "this Rust was not installed by rustup, so `rustup {}` cannot be run. \
             Install that part as your system does, or use rustup.",
            args.join(" ")
        ));
    }
    run(Command::new("rustup").args(args).current_dir(workspace.root()))
}
