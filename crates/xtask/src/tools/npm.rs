//! Node and the npm packages.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::Trouble;
use crate::run::{find_program, output, run, say};
use crate::version::Version;
use crate::workspace::Workspace;

/// npm is a script, and Windows starts scripts only by their full name.
const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// The lock file that `node_modules` was installed from, kept inside it.
const STAMP: &str = "node_modules/.installed-from.json";

/// Installs the packages of `package-lock.json` if they are not those in `node_modules`.
pub fn ensure(workspace: &Workspace) -> Result<(), Trouble> {
    ensure_node()?;
    let stamp = workspace.path(STAMP);
    let lock =
        fs::read(workspace.path("package-lock.json")).map_err(|e| format!("package-lock.json cannot be read: {e}."))?;
    if fs::read(&stamp).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    say("Installing the npm packages.");
    run(npm(workspace.root()).arg("ci"))?;
    // Last, so that an interrupted install is not taken for a whole one.
    fs::write(&stamp, lock).map_err(|e| format!("{} cannot be written: {e}.", stamp.display()))
}

/// npm, in a folder.
pub fn npm(folder: &Path) -> Command {
    let mut command = Command::new(NPM);
    command.current_dir(folder);
    command
}

/// Node, in the workspace root. Packages' programs are started through it, which works alike on
/// every system.
pub fn node(workspace: &Workspace) -> Command {
    let mut command = Command::new("node");
    command.current_dir(workspace.root());
    command
}

fn ensure_node() -> Result<(), Trouble> {
    const WANTED: &str = "Node 20.19 or later of 20, or 22.12 or later";
    let text = output(Command::new("node").arg("--version"))
        .ok_or_else(|| format!("Node was not found. Install {WANTED}, with npm."))?;
    let version =
        Version::in_text(&text).ok_or_else(|| format!("`node --version` printed no version. Install {WANTED}."))?;
    if !is_wanted(version) {
        return Err(format!("Node {version} was found, but the build wants {WANTED}. Install one of these."));
    }
    if cfg!(unix) && find_program(NPM).is_none() {
        return Err(format!("Node {version} was found, but not npm. Install npm."));
    }
    Ok(())
}

/// What Vite 8 runs on; 21 and early 22 lack what it needs.
fn is_wanted(version: Version) -> bool {
    version >= Version::new(22, 12, 0) || (version.major == 20 && version >= Version::new(20, 19, 0))
}

#[cfg(test)]
mod tests {
    use super::is_wanted;
    use crate::version::Version;

    #[test]
    fn knows_the_versions_that_vite_runs_on() {
        for wanted in [(20, 19, 0), (20, 20, 2), (22, 12, 0), (23, 0, 0), (24, 1, 0)] {
            let version = Version::new(wanted.0, wanted.1, wanted.2);
            assert!(is_wanted(version), "{version}");
        }
        for unwanted in [(18, 20, 0), (20, 9, 0), (21, 7, 0), (22, 11, 9)] {
            let version = Version::new(unwanted.0, unwanted.1, unwanted.2);
            assert!(!is_wanted(version), "{version}");
        }
    }
}
