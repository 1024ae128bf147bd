//! `cargo xtask bench`: measures the page in a real browser.

use std::process::ExitCode;

use super::build;
use crate::Trouble;
use crate::run::run;
use crate::tools::{browser, npm};
use crate::workspace::Workspace;

/// Builds the page as it is published, then measures it and prints the tables of `docs/performance.md`.
pub fn command(workspace: &Workspace, args: &[String]) -> Result<ExitCode, Trouble> {
    if let Some(unknown) = args.first() {
        return Err(format!("`bench` takes no argument, and was given `{unknown}`."));
    }
    let found = browser::ensure()?;
    build::both(workspace)?;
    run(npm::node(workspace)
        .arg("tests/bench/main.js")
        .env("NCTAPE_DIST", workspace.dist())
        .env("NCTAPE_BROWSER", found.browser))?;
    Ok(ExitCode::SUCCESS)
}
