//! Reads from a test runner's output how many tests passed and failed.

use std::ops::AddAssign;

/// Tests that passed and failed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Tests that passed.
    pub passed: u64,
    /// Tests that failed.
    pub failed: u64,
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
    }
}

/// Reads one line of a test runner; nothing where the line counts no tests.
pub type ReadLine = fn(&str) -> Option<Tally>;

/// `test result: ok. 3 passed; 0 failed; 1 ignored; …`, which `cargo test` prints for each test
/// program, and wasm-bindgen's runner likewise.
pub fn cargo_line(line: &str) -> Option<Tally> {
    let (_, counts) = line.trim().strip_prefix("test result: ")?.split_once(". ")?;
    let mut tally = Tally::default();
    for count in counts.split(';') {
        match number_before(count.trim()) {
            Some((n, "passed")) => tally.passed = n,
            Some((n, "failed")) => tally.failed = n,
            _ => {}
        }
    }
    Some(tally)
}

/// `ℹ pass 3`, `ℹ fail 1` and `ℹ cancelled 0` of Node's `spec` reporter, each on its own line.
pub fn node_line(line: &str) -> Option<Tally> {
    let (word, n) = line.strip_prefix("ℹ ")?.trim_end().split_once(' ')?;
    let n = n.parse().ok()?;
    match word {
        "pass" => Some(Tally { passed: n, failed: 0 }),
        // A cancelled test was not finished: it shows nothing, so it counts as failed.
        "fail" | "cancelled" => Some(Tally { passed: 0, failed: n }),
        _ => None,
    }
}

fn number_before(text: &str) -> Option<(u64, &str)> {
    let (n, word) = text.split_once(' ')?;
    Some((n.parse().ok()?, word))
}

#[cfg(test)]
mod tests {
    use super::{ReadLine, Tally, cargo_line, node_line};

    fn sum(read: ReadLine, output: &str) -> Tally {
        let mut tally = Tally::default();
        for line in output.lines().filter_map(read) {
            tally += line;
        }
        tally
    }

    #[test]
    fn adds_the_programs_of_cargo_test() {
        let output = "
running 2 tests
test reads_x ... ok
test result: ok. 2 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s
test result: FAILED. 3 passed; 1 failed; 4 ignored; 0 measured; 0 filtered out; finished in 0.1s
";
        assert_eq!(sum(cargo_line, output), Tally { passed: 5, failed: 1 });
    }

    #[test]
    fn counts_a_cancelled_node_test_as_failed() {
        let output = "✔ inits (3ms)\nℹ tests 9\nℹ pass 6\nℹ fail 1\nℹ cancelled 2\nℹ duration_ms 812.5\n";
        assert_eq!(sum(node_line, output), Tally { passed: 6, failed: 3 });
    }

    #[test]
    fn ignores_other_lines() {
        assert_eq!(cargo_line("test result_is_kept ... ok"), None);
        assert_eq!(node_line("✔ pass 3"), None);
    }
}
