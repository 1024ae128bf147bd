//! What a request asks for.

use std::path::{Component, Path, PathBuf};

/// A request that can be answered with a file.
#[derive(Debug, PartialEq, Eq)]
pub struct Request {
    /// Whether the body is left out of the answer.
    pub head_only: bool,
    /// The file, relative to the served folder.
    pub file: PathBuf,
}

/// Why a request gets no file.
#[derive(Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The request is no HTTP, or its path leads out of the folder.
    Bad,
    /// Only GET and HEAD are served.
    Method,
}

impl Request {
    /// Reads the first line of a request: `GET /assets/a.js?v=1 HTTP/1.1`.
    pub fn from_line(line: &str) -> Result<Self, Refusal> {
        let mut words = line.split_ascii_whitespace();
        let (Some(method), Some(target), Some(_), None) = (words.next(), words.next(), words.next(), words.next())
        else {
            return Err(Refusal::Bad);
        };
        let head_only = match method {
            "GET" => false,
            "HEAD" => true,
            _ => return Err(Refusal::Method),
        };
        let file = relative_file(target).ok_or(Refusal::Bad)?;
        Ok(Self { head_only, file })
    }
}

/// The file that a target names, or nothing where it leads out of the folder.
fn relative_file(target: &str) -> Option<PathBuf> {
    let path = target.split(['?', '#']).next()?.strip_prefix('/')?;
    let path = percent_decoded(path)?;
    // A backslash or a drive's colon separates on Windows only; no file of the site has one.
    if path.contains(['\\', ':', '\0']) {
        return None;
    }
    let mut file = PathBuf::new();
    for component in Path::new(&path).components() {
        match component {
            Component::Normal(name) => file.push(name),
            Component::CurDir => {}
            Component::ParentDir | Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    if path.is_empty() || path.ends_with('/') {
        file.push("index.html");
    }
    Some(file)
}

fn percent_decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte == b'%' {
            let high = char::from(rest.next()?).to_digit(16)?;
            let low = char::from(rest.next()?).to_digit(16)?;
            bytes.push(u8::try_from(high * 16 + low).ok()?);
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::{Refusal, Request};
    use std::path::PathBuf;

    fn file(target: &str) -> Result<PathBuf, Refusal> {
        Request::from_line(&format!("GET {target} HTTP/1.1")).map(|request| request.file)
    }

    #[test]
    fn names_files_and_folders() {
        assert_eq!(file("/"), Ok("index.html".into()));
        assert_eq!(file("/embed/"), Ok("embed/index.html".into()));
        assert_eq!(file("/assets/a%20b.js?v=1"), Ok("assets/a b.js".into()));
        assert_eq!(file("/./a..b.js"), Ok("a..b.js".into()));
    }

    #[test]
    fn refuses_what_leads_out_of_the_folder() {
        for target in [
            "/../Cargo.toml",
            "/assets/../../Cargo.toml",
            "/%2e%2e/Cargo.toml",
            "/..%2fCargo.toml",
            "//etc/passwd",
            "/%2Fetc/passwd",
            "/..%5cCargo.toml",
            "/C:/Windows/win.ini",
            "/a%00.js",
            "/a%f",
            "/a%ff",
            "a.js",
        ] {
            assert_eq!(file(target), Err(Refusal::Bad), "{target}");
        }
    }

    #[test]
    fn reads_and_changes_nothing() {
        let line = |method: &str| Request::from_line(&format!("{method} / HTTP/1.1"));
        assert!(line("HEAD").is_ok_and(|request| request.head_only));
        assert_eq!(line("POST"), Err(Refusal::Method));
        assert_eq!(Request::from_line("GET /"), Err(Refusal::Bad));
        assert_eq!(Request::from_line(""), Err(Refusal::Bad));
    }
}
