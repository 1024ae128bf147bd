//! `cargo xtask`: builds, serves and tests the project, and installs what that needs.
//!
//! Everything is found from the workspace root, so it works from any folder inside it.

mod commands;
mod http;
mod run;
mod summary;
mod tally;
mod tools;
mod version;
mod workspace;

use std::process::ExitCode;

use commands::{bench, build, serve, test};
use workspace::Workspace;

/// What went wrong, in a plain sentence that says what was found and what to do about it.
type Trouble = String;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match dispatch(&args) {
        Ok(code) => code,
        Err(trouble) => {
            eprintln!("\nxtask: {trouble}");
            ExitCode::FAILURE
        }
    }
}

fn dispatch(args: &[String]) -> Result<ExitCode, Trouble> {
    let workspace = Workspace::find()?;
    let (command, rest) = match args.split_first() {
        Some((command, rest)) => (command.as_str(), rest),
        None => ("", args),
    };
    match command {
        "serve" => serve::command(&workspace, rest),
        "test" => test::command(&workspace, rest),
        "build" => build::command(&workspace, rest),
        "bench" => bench::command(&workspace, rest),
        "help" | "--help" | "-h" => {
            println!("{}", usage());
            Ok(ExitCode::SUCCESS)
        }
        "" => {
            eprintln!("{}", usage());
            Ok(ExitCode::FAILURE)
        }
        unknown => Err(format!("there is no command `{unknown}`.\n\n{}", usage())),
    }
}

fn usage() -> String {
    format!(
        "\
cargo xtask serve [--port N] [--no-open]   build the page and serve it on this machine
cargo xtask test [suite…]                  run every check, or only the suites named
cargo xtask build                          leave the npm package in pkg/ and the site in dist/
cargo xtask bench                          measure the page in a browser; `cargo bench` measures the core

Suites: {}
Each command installs what it needs. Tools that are built from source are kept in
{}",
        test::names().join(", "),
        match tools::cache::folder() {
            Ok(folder) => format!("{} (NCTAPE_CACHE names another place).", folder.display()),
            Err(trouble) => trouble,
        }
    )
}
