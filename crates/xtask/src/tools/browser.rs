//! The browser for the tests, and the driver that goes with it.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use crate::Trouble;
use crate::run::{find_program, output, run, say};
use crate::version::Version;

/// A browser and the driver of the same major version.
pub struct Browser {
    /// Chromium or Chrome.
    pub browser: PathBuf,
    /// chromedriver.
    pub driver: PathBuf,
}

/// Finds the browser and its driver, and installs them where this can be done.
pub fn ensure() -> Result<Browser, Trouble> {
    if (browsers()?.is_empty() || driver()?.is_none()) && can_apt_get() {
        install()?;
    }
    let browsers = browsers()?;
    if browsers.is_empty() {
        return Err(missing("neither Chromium nor Chrome was found"));
    }
    let driver = driver()?.ok_or_else(|| missing("chromedriver was not found"))?;
    let wanted = major(&driver);
    let fitting = browsers.iter().find(|browser| wanted.is_none() || major(browser) == wanted);
    match fitting {
        Some(browser) => Ok(Browser { browser: browser.clone(), driver }),
        None => Err(format!(
            "chromedriver is of version {}, and none of these browsers is: {}. \
             Install the chromedriver that goes with one of them.",
            wanted.unwrap_or_default(),
            browsers.iter().map(|browser| browser.display().to_string()).collect::<Vec<_>>().join(", ")
        )),
    }
}

fn browsers() -> Result<Vec<PathBuf>, Trouble> {
    if let Some(browser) = named_by("NCTAPE_BROWSER")? {
        return Ok(vec![browser]);
    }
    let on_path = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"]
        .iter()
        .filter_map(|name| find_program(name));
    // Where Chrome's own installer puts it, off PATH, on macOS and Windows.
    let elsewhere = [
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        "/Applications/Chromium.app/Contents/MacOS/Chromium",
        r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    ]
    .iter()
    .map(PathBuf::from)
    .filter(|file| file.is_file());
    Ok(on_path.chain(elsewhere).collect())
}

fn driver() -> Result<Option<PathBuf>, Trouble> {
    let named = named_by("CHROMEDRIVER")?;
    Ok(named.or_else(|| find_program("chromedriver")))
}

/// The program that a variable names.
fn named_by(variable: &str) -> Result<Option<PathBuf>, Trouble> {
    match std::env::var_os(variable).map(PathBuf::from) {
        Some(file) if !file.is_file() => {
            Err(format!("{variable} names {}, which is no file. Correct or unset it.", file.display()))
        }
        named => Ok(named),
    }
}

fn major(program: &PathBuf) -> Option<u32> {
    // Chrome on Windows opens a window instead of printing its version.
    if cfg!(windows) {
        return None;
    }
    let text = output(Command::new(program).arg("--version"))?;
    Version::in_text(&text).map(|version| version.major)
}

/// Only Debian: Ubuntu's packages of these names are stubs of another installer.
fn can_apt_get() -> bool {
    let is_debian =
        fs::read_to_string("/etc/os-release").is_ok_and(|text| text.lines().any(|line| line == "ID=debian"));
    let is_root = output(Command::new("id").arg("-u")).is_some_and(|id| id.trim() == "0");
    is_debian && is_root && find_program("apt-get").is_some()
}

fn install() -> Result<(), Trouble> {
    say("Installing Chromium and its driver.");
    run(&mut apt_get(&["update"]))?;
    run(&mut apt_get(&["install", "--yes", "--no-install-recommends", "chromium", "chromium-driver"]))
}

fn apt_get(args: &[&str]) -> Command {
    let mut command = Command::new("apt-get");
    command
        .args(args)
        // It would wait for an answer that nobody gives.
        .env("DEBIAN_FRONTEND", "noninteractive");
    command
}

fn missing(what: &str) -> Trouble {
    format!(
        "{what}, and the tests in the browser need both. Install Chromium or Chrome and the \
         chromedriver of the same version (on Debian, as root: `apt-get install chromium \
         chromium-driver`), or name them in NCTAPE_BROWSER and CHROMEDRIVER."
    )
}
