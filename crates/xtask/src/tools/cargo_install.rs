//! Programs from crates.io, built once for each version.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use super::cache;
use crate::Trouble;
use crate::run::{output, run, say};
use crate::version::Version;

/// A program that a crate brings.
pub struct Program<'a> {
    /// The crate.
    pub package: &'a str,
    /// Its version, exactly this one.
    pub version: Version,
    /// The program by whose `--version` an install is known to be whole.
    pub binary: &'a str,
    /// Whether to build with the crate's own lock file.
    pub locked: bool,
}

impl Program<'_> {
    /// Installs the program if it is not there, and gives the folder that it lies in.
    pub fn ensure(&self) -> Result<PathBuf, Trouble> {
        let Self { package, version, .. } = self;
        let root = cache::folder()?.join("tools").join(format!("{package}-{version}"));
        let bin = root.join("bin");
        if self.works_in(&bin) {
            return Ok(bin);
        }
        say(&format!("Installing {package} {version}; built from source once, it takes a few minutes."));
        fs::create_dir_all(&root).map_err(|e| format!("{} cannot be made: {e}.", root.display()))?;
        let mut install = Command::new("cargo");
        install.arg("install").arg(package).arg("--version").arg(version.to_string());
        if self.locked {
            install.arg("--locked");
        }
        // `--force`: what an interrupted install left must not count as installed.
        install
            .arg("--force")
            .arg("--root")
            .arg(&root)
            // Away from the workspace: neither its settings nor its target folder are meant here.
            .current_dir(&root);
        for variable in ["CARGO_TARGET_DIR", "CARGO_BUILD_TARGET", "CARGO_ENCODED_RUSTFLAGS", "RUSTFLAGS"] {
            install.env_remove(variable);
        }
        run(&mut install)?;
        if self.works_in(&bin) {
            Ok(bin)
        } else {
            Err(format!(
                "{package} was installed but does not say that it is {version}. Delete {} and try again.",
                root.display()
            ))
        }
    }

    fn works_in(&self, bin: &std::path::Path) -> bool {
        let program = bin.join(format!("{}{}", self.binary, std::env::consts::EXE_SUFFIX));
        output(Command::new(program).arg("--version")).and_then(|text| Version::in_text(&text)) == Some(self.version)
    }
}
