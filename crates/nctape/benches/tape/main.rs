//! `cargo bench`: how fast a tape is checked and edited. It prints the tables that `docs/performance.md` explains.
//!
//! `cargo bench -- edit` measures one part: `check`, `growth`, `awkward` or `edit`.

mod check;
mod edit;
mod growth;
mod measure;
mod peers;
mod tapes;

use nctape::{Severity, Tape};
use std::process::ExitCode;

const PARTS: [(&str, fn()); 4] =
    [("check", check::run), ("growth", growth::run), ("awkward", growth::run_awkward), ("edit", edit::run)];

fn main() -> ExitCode {
    // Cargo passes `--bench`.
    let names: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with("--")).collect();
    if let Some(unknown) = names.iter().find(|name| PARTS.iter().all(|(part, _)| part != name)) {
        eprintln!("there is no part `{unknown}`; the parts are check, growth, awkward and edit.");
        return ExitCode::FAILURE;
    }
    for (part, run) in PARTS {
        if names.is_empty() || names.iter().any(|name| name == part) {
            run();
        }
    }
    ExitCode::SUCCESS
}

/// All that is known of a tape, so that nothing of it is left for later.
fn ask(tape: &Tape) {
    let severities = [Severity::Info, Severity::Warning, Severity::Error];
    std::hint::black_box((severities.map(|severity| tape.count(severity)), tape.totals(), tape.spans().list.len()));
}
