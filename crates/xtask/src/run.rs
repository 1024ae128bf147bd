//! Starts other programs.

use std::ffi::OsString;
use std::io::{BufRead, BufReader, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};

use crate::Trouble;
use crate::tally::{ReadLine, Tally};

/// Runs a program, its output streamed, and wants it to succeed.
pub fn run(command: &mut Command) -> Result<(), Trouble> {
    announce(command);
    let status = command.status().map_err(|e| not_started(command, &e))?;
    verdict(command, status)
}

/// Runs a test runner, its output streamed, and adds up the tests that it counts.
pub fn run_tests(command: &mut Command, read: ReadLine) -> (Tally, Result<(), Trouble>) {
    announce(command);
    let mut tally = Tally::default();
    let result = stream(command, |line| {
        if let Some(counted) = read(line) {
            tally += counted;
        }
    });
    (tally, result)
}

fn stream(command: &mut Command, mut each_line: impl FnMut(&str)) -> Result<(), Trouble> {
    // Standard error stays the terminal's own, so that progress and colours are kept.
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(|e| not_started(command, &e))?;
    if let Some(stdout) = child.stdout.take() {
        let mut reader = BufReader::new(stdout);
        let mut bytes = Vec::new();
        // By bytes: a test may print what is not UTF-8.
        while reader.read_until(b'\n', &mut bytes).unwrap_or(0) > 0 {
            let mut out = std::io::stdout().lock();
            // Nobody may be listening any more; the tests are counted all the same.
            let _ = out.write_all(&bytes).and_then(|()| out.flush());
            each_line(String::from_utf8_lossy(&bytes).trim_end());
            bytes.clear();
        }
    }
    let status = child.wait().map_err(|e| not_started(command, &e))?;
    verdict(command, status)
}

fn verdict(command: &Command, status: ExitStatus) -> Result<(), Trouble> {
    if status.success() { Ok(()) } else { Err(format!("`{}` failed ({status}).", line(command))) }
}

/// What a program prints, or nothing if it is missing or fails.
pub fn output(command: &mut Command) -> Option<String> {
    let output = command.stdin(Stdio::null()).stderr(Stdio::null()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    output.status.success().then_some(text)
}

/// The program of this name on PATH.
pub fn find_program(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let name = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    std::env::split_paths(&path).map(|folder| folder.join(&name)).find(|file| file.is_file())
}

/// PATH with these folders before it.
pub fn path_with(folders: &[PathBuf]) -> Result<OsString, Trouble> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let all = folders.iter().cloned().chain(std::env::split_paths(&path));
    std::env::join_paths(all)
        .map_err(|e| format!("PATH cannot be put together: {e}. Move the project to a plain path."))
}

/// Says what is done next, as every command that takes its time does.
pub fn say(text: &str) {
    println!("── {text}");
}

fn announce(command: &Command) {
    println!("$ {}", line(command));
}

/// The command as one would type it; folders of programs and variables are left out.
fn line(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let mut words = vec![program.file_stem().unwrap_or(program.as_os_str()).to_string_lossy().into_owned()];
    words.extend(command.get_args().map(|arg| arg.to_string_lossy().into_owned()));
    words.join(" ")
}

fn not_started(command: &Command, error: &std::io::Error) -> Trouble {
    let program = command.get_program().to_string_lossy();
    if error.kind() == ErrorKind::NotFound {
        format!("`{program}` was not found. Install it, or put it on PATH.")
    } else {
        format!("`{program}` could not be started: {error}.")
    }
}
