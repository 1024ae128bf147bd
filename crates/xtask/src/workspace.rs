//! Where things lie in the workspace.

use std::path::{Path, PathBuf};

use crate::Trouble;

/// The workspace that this command works on.
pub struct Workspace {
    root: PathBuf,
}

impl Workspace {
    /// Finds the workspace from the manifest that `cargo run` names, whatever the current folder.
    pub fn find() -> Result<Self, Trouble> {
        // The variable comes first: it follows a checkout that was moved after it was compiled.
        let manifest = std::env::var_os("CARGO_MANIFEST_DIR")
            .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
        match manifest.ancestors().nth(2) {
            Some(root) if root.join("Cargo.toml").is_file() => Ok(Self { root: root.into() }),
            _ => Err(format!(
                "no workspace was found above {}. Start it as `cargo xtask` inside the project.",
                manifest.display()
            )),
        }
    }

    /// The folder of the workspace's `Cargo.toml`.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// A path inside the workspace.
    pub fn path(&self, relative: &str) -> PathBuf {
        self.root.join(relative)
    }

    /// The npm package that a build leaves.
    pub fn pkg(&self) -> PathBuf {
        self.path("pkg")
    }

    /// The static site that a build leaves.
    pub fn dist(&self) -> PathBuf {
        self.path("dist")
    }
}
