//! wasm-bindgen's command line and its test runner.

use std::fs;
use std::path::PathBuf;

use super::cargo_install::Program;
use crate::Trouble;
use crate::version::Version;
use crate::workspace::Workspace;

/// Installs the command line that fits the crate, and gives its folder.
pub fn ensure(workspace: &Workspace) -> Result<PathBuf, Trouble> {
    let lock = workspace.path("Cargo.lock");
    let text = fs::read_to_string(&lock).map_err(|e| format!("Cargo.lock cannot be read: {e}."))?;
    let version = locked_version(&text, "wasm-bindgen")
        .ok_or("Cargo.lock names no version of wasm-bindgen, which nctape-wasm needs. Restore Cargo.lock.")?;
    Program {
        package: "wasm-bindgen-cli",
        version,
        binary: "wasm-bindgen",
        // Its own lock file names a crate version that the registry no longer has.
        locked: false,
    }
    .ensure()
}

/// The version of a package in the text of a `Cargo.lock`.
fn locked_version(lock: &str, package: &str) -> Option<Version> {
    let name = format!("name = \"{package}\"");
    let mut lines = lock.lines().skip_while(|line| *line != name);
    let version = lines.nth(1)?.strip_prefix("version = \"")?;
    // The crate's version and the command line's must be equal to the last number.
    Version::in_text(version.trim_end_matches('"'))
}

#[cfg(test)]
mod tests {
    use super::locked_version;
    use crate::version::Version;

    const LOCK: &str = "\
[[package]]
name = \"wasm-bindgen\"
version = \"0.2.130\"
dependencies = [
 \"wasm-bindgen-macro\",
]

[[package]]
name = \"wasm-bindgen-macro\"
version = \"0.2.131\"
";

    #[test]
    fn reads_the_version_of_just_that_package() {
        assert_eq!(locked_version(LOCK, "wasm-bindgen"), Some(Version::new(0, 2, 130)));
        assert_eq!(locked_version(LOCK, "wasm-bindgen-macro"), Some(Version::new(0, 2, 131)));
        assert_eq!(locked_version(LOCK, "wasm"), None);
    }
}
