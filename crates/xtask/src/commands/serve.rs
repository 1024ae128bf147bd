//! `cargo xtask serve`: builds the page, serves it on this machine and opens it.

use std::env;
use std::process::{Command, ExitCode, Stdio};

use super::build;
use crate::Trouble;
use crate::http;
use crate::run::say;
use crate::workspace::Workspace;

/// Any port that nothing else is known for would do. It stays the same, so that what the page keeps
/// for its origin is found again the next time.
const USUAL_PORT: u16 = 8017;

#[derive(Debug, PartialEq, Eq)]
struct Options {
    port: Option<u16>,
    open: bool,
}

/// Builds, then serves until it is ended.
pub fn command(workspace: &Workspace, args: &[String]) -> Result<ExitCode, Trouble> {
    let options = options(args)?;
    build::both(workspace)?;
    let listener = http::listen(options.port, USUAL_PORT)?;
    let port = listener.local_addr().map_err(|e| format!("the port that was taken is not known: {e}."))?.port();
    let address = format!("http://127.0.0.1:{port}/");
    say(&format!("The playground is at {address} until Ctrl+C is pressed."));
    if options.open && has_desktop() {
        open(&address);
    }
    http::serve(&listener, &workspace.dist())?;
    Ok(ExitCode::SUCCESS)
}

fn options(args: &[String]) -> Result<Options, Trouble> {
    let mut options = Options { port: None, open: true };
    let mut args = args.iter();
    while let Some(arg) = args.next() {
        let port = match arg.as_str() {
            "--no-open" => {
                options.open = false;
                continue;
            }
            "--port" => args.next().map(String::as_str),
            other => match other.strip_prefix("--port=") {
                Some(port) => Some(port),
                None => {
                    return Err(format!("`serve` knows --port N and --no-open, and was given `{other}`."));
                }
            },
        };
        options.port = Some(
            port.and_then(|port| port.parse().ok())
                .ok_or("--port wants a number from 0 to 65535; 0 takes any free port.")?,
        );
    }
    Ok(options)
}

fn has_desktop() -> bool {
    let is_set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    let windows_or_mac = cfg!(any(windows, target_os = "macos"));
    !is_set("CI") && (windows_or_mac || is_set("DISPLAY") || is_set("WAYLAND_DISPLAY"))
}

/// Opens the address in the user's browser. Where that fails, the printed address is enough.
fn open(address: &str) {
    let mut command = if cfg!(windows) {
        let mut start = Command::new("cmd");
        start.args(["/C", "start", ""]);
        start
    } else if cfg!(target_os = "macos") {
        Command::new("open")
    } else {
        Command::new("xdg-open")
    };
    let _ = command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
}

#[cfg(test)]
mod tests {
    use super::{Options, options};

    fn read(args: &[&str]) -> Option<Options> {
        let args: Vec<String> = args.iter().map(ToString::to_string).collect();
        options(&args).ok()
    }

    #[test]
    fn reads_port_and_no_open() {
        let with = |port, open| Some(Options { port, open });
        assert_eq!(read(&[]), with(None, true));
        assert_eq!(read(&["--no-open", "--port", "0"]), with(Some(0), false));
        assert_eq!(read(&["--port=9000"]), with(Some(9000), true));
    }

    #[test]
    fn refuses_what_is_no_port() {
        assert_eq!(read(&["--port"]), None);
        assert_eq!(read(&["--port", "65536"]), None);
        assert_eq!(read(&["9000"]), None);
    }
}
