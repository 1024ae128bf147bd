//! The folder in which tools built from source are kept, so that a second clone finds them built.

use std::env;
use std::path::PathBuf;

use crate::Trouble;

/// `NCTAPE_CACHE`, or `nctape` in the user's cache folder.
pub fn folder() -> Result<PathBuf, Trouble> {
    if let Some(folder) = variable("NCTAPE_CACHE") {
        return std::path::absolute(&folder)
            .map_err(|e| format!("NCTAPE_CACHE is {}, which is no path: {e}.", folder.display()));
    }
    let user = if cfg!(windows) {
        variable("LOCALAPPDATA")
    } else if let Some(cache) = variable("XDG_CACHE_HOME") {
        Some(cache)
    } else {
        let below_home = if cfg!(target_os = "macos") { "Library/Caches" } else { ".cache" };
        variable("HOME").map(|home| home.join(below_home))
    };
    user.map(|folder| folder.join("nctape"))
        .ok_or_else(|| "no cache folder is known: set NCTAPE_CACHE to a folder that may be written.".into())
}

fn variable(name: &str) -> Option<PathBuf> {
    env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from)
}
