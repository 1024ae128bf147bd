//! The suites of `cargo xtask test`, in the order in which they run: what is quick and what the
//! later ones need comes first.

use std::path::PathBuf;
use std::process::Command;

use super::build;
use crate::Trouble;
use crate::run::{run, run_tests};
use crate::tally::{ReadLine, Tally, cargo_line, node_line};
use crate::tools::{browser, npm, rust, wasm_pack};
use crate::workspace::Workspace;

/// The tests that ran, where the suite counts any, and why it failed, if it did.
pub type Run = (Option<Tally>, Result<(), Trouble>);

/// One suite.
pub struct Suite {
    /// The name by which it is asked for.
    pub name: &'static str,
    /// The suite whose result it works on, which is run with it.
    pub needs: Option<&'static str>,
    /// Runs it.
    pub run: fn(&Workspace) -> Run,
}

/// Every suite.
pub const SUITES: [Suite; 11] = [
    suite("fmt", None, fmt),
    suite("clippy", None, clippy),
    suite("clippy-wasm", None, clippy_wasm),
    suite("native", None, native),
    suite("doc", None, doc),
    suite("package", None, |w| (None, build::package(w))),
    suite("site", Some("package"), |w| (None, build::site(w))),
    suite("wasm", None, wasm),
    suite("types", Some("package"), types),
    suite("node", Some("package"), node),
    suite("e2e", Some("site"), e2e),
];

const fn suite(name: &'static str, needs: Option<&'static str>, run: fn(&Workspace) -> Run) -> Suite {
    Suite { name, needs, run }
}

fn fmt(workspace: &Workspace) -> Run {
    check(|| {
        rust::ensure_component(workspace, "rustfmt")?;
        run(rust::cargo(workspace).args(["fmt", "--all", "--check"]))
    })
}

fn clippy(workspace: &Workspace) -> Run {
    check(|| {
        rust::ensure_component(workspace, "clippy")?;
        run(rust::cargo(workspace).args(["clippy", "--workspace", "--all-targets"]).args(["--", "-D", "warnings"]))
    })
}

fn clippy_wasm(workspace: &Workspace) -> Run {
    check(|| {
        rust::ensure_component(workspace, "clippy")?;
        rust::ensure_target(workspace)?;
        let mut clippy = rust::cargo(workspace);
        clippy.args(["clippy", "--package", "nctape-wasm", "--all-targets", "--target", rust::WASM]);
        run(clippy.args(["--", "-D", "warnings"]))
    })
}

fn native(workspace: &Workspace) -> Run {
    tests(rust::cargo(workspace).args(["test", "--workspace"]).arg("--no-fail-fast"), cargo_line)
}

fn doc(workspace: &Workspace) -> Run {
    check(|| run(rust::cargo(workspace).args(["doc", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings")))
}

fn wasm(workspace: &Workspace) -> Run {
    let prepared = browser::ensure().and_then(|b| Ok((b, wasm_pack::command(workspace)?)));
    match prepared {
        Ok((browser, mut command)) => tests(
            command
                .args(["test", "--headless", "--chrome", "--chromedriver"])
                .arg(browser.driver)
                .args(["--mode", "no-install", "crates/nctape-wasm"])
                // Seconds. The 20 by default are short where the browser starts for the first time
                // on a machine of two cores.
                .env("WASM_BINDGEN_TEST_TIMEOUT", "120"),
            cargo_line,
        ),
        Err(trouble) => (None, Err(trouble)),
    }
}

fn types(workspace: &Workspace) -> Run {
    check(|| {
        npm::ensure(workspace)?;
        run(npm::node(workspace).args(["node_modules/typescript/bin/tsc", "--project", "."]))
    })
}

fn node(workspace: &Workspace) -> Run {
    match npm::ensure(workspace).and_then(|()| node_tests(workspace, "tests/node")) {
        Ok(mut command) => tests(&mut command, node_line),
        Err(trouble) => (None, Err(trouble)),
    }
}

fn e2e(workspace: &Workspace) -> Run {
    let prepared = npm::ensure(workspace)
        .and_then(|()| browser::ensure())
        .and_then(|browser| Ok((browser, node_tests(workspace, "tests/e2e")?)));
    match prepared {
        Ok((browser, mut command)) => tests(command.env("NCTAPE_BROWSER", browser.browser), node_line),
        Err(trouble) => (None, Err(trouble)),
    }
}

/// Node's test runner over the files of a folder. They are listed here: a folder as argument means
/// one thing to Node 20 and another to Node 22.
fn node_tests(workspace: &Workspace, folder: &str) -> Result<Command, Trouble> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(workspace.path(folder))
        .map_err(|e| format!("{folder} cannot be read: {e}."))?
        .flatten()
        .map(|entry| PathBuf::from(folder).join(entry.file_name()))
        .filter(|file| file.to_string_lossy().ends_with(".test.js"))
        .collect();
    files.sort();
    if files.is_empty() {
        return Err(format!("{folder} holds no file named *.test.js."));
    }
    let mut command = npm::node(workspace);
    command
        .arg("--test")
        // `spec` is not the default where the output is no terminal, and its last lines are read.
        .arg("--test-reporter=spec")
        // Milliseconds: ten minutes, many times what a file takes, so that one that hangs ends.
        .arg("--test-timeout=600000")
        .args(files)
        .env("NCTAPE_PKG", workspace.pkg())
        .env("NCTAPE_DIST", workspace.dist())
        // Colours would stand between the words that are read.
        .env_remove("FORCE_COLOR");
    Ok(command)
}

fn check(f: impl FnOnce() -> Result<(), Trouble>) -> Run {
    (None, f())
}

/// Runs tests, and wants there to be some: a suite that runs none shows nothing.
fn tests(command: &mut Command, read: ReadLine) -> Run {
    let (tally, result) = run_tests(command, read);
    let result = result.and_then(|()| match tally {
        Tally { failed: 1.., .. } => Err("tests failed.".into()),
        Tally { passed: 0, .. } => Err("no test ran.".into()),
        _ => Ok(()),
    });
    (Some(tally), result)
}
