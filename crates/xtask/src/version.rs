//! Version numbers as tools print them.

use std::fmt;

/// Major, minor and patch. Chromium's fourth number is not looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    /// The first number.
    pub major: u32,
    /// The second number, 0 where there is none.
    pub minor: u32,
    /// The third number, 0 where there is none.
    pub patch: u32,
}

impl Version {
    /// A version from its three numbers.
    pub const fn new(major: u32, minor: u32, patch: u32) -> Self {
        Self { major, minor, patch }
    }

    /// The first version in what `TOOL --version` printed: `v20.19.0`, `wasm-pack 0.15.1`,
    /// `Chromium 156.0.8078.79 built on Debian`.
    pub fn in_text(text: &str) -> Option<Self> {
        text.split_whitespace().find_map(Self::from_word)
    }

    fn from_word(word: &str) -> Option<Self> {
        let word = word.strip_prefix('v').unwrap_or(word);
        // A suffix such as `-nightly` is not part of the numbers.
        let numbers = word.split(['-', '+']).next()?;
        if !numbers.contains('.') {
            return None;
        }
        let mut parts = numbers.split('.').map(|part| part.parse::<u32>().ok());
        let major = parts.next()??;
        let minor = parts.next()??;
        let patch = parts.next().flatten().unwrap_or(0);
        Some(Self::new(major, minor, patch))
    }
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}.{}", self.major, self.minor, self.patch)
    }
}

#[cfg(test)]
mod tests {
    use super::Version;

    #[test]
    fn reads_what_tools_print() {
        for (text, expected) in [
            ("v20.20.2\n", Version::new(20, 20, 2)),
            ("wasm-pack 0.15.1", Version::new(0, 15, 1)),
            ("wasm-bindgen 0.2.130", Version::new(0, 2, 130)),
            ("Chromium 156.0.8078.79 built on Debian GNU/Linux 12", Version::new(156, 0, 8078)),
            ("ChromeDriver 156.0.8078.79 (abc1234)", Version::new(156, 0, 8078)),
            ("v22.12.0-nightly2024", Version::new(22, 12, 0)),
        ] {
            assert_eq!(Version::in_text(text), Some(expected), "{text}");
        }
    }

    #[test]
    fn finds_none_where_there_is_none() {
        assert_eq!(Version::in_text("command not found"), None);
        assert_eq!(Version::in_text("12 tapes"), None);
    }

    #[test]
    fn compares_by_number_not_by_text() {
        assert!(Version::new(20, 9, 0) < Version::new(20, 19, 0));
        assert!(Version::new(22, 0, 9) > Version::new(20, 19, 0));
        assert!(Version::new(0, 2, 99) < Version::new(0, 2, 130));
    }
}
