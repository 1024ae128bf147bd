//! The end of `cargo xtask test`: a line for each suite, then the sum.

use std::fmt::Write;
use std::time::Duration;

use crate::Trouble;
use crate::tally::Tally;

/// What became of one suite.
pub struct Outcome {
    /// The name of the suite.
    pub name: &'static str,
    /// Its tests, where it counts any; a check such as `fmt` counts none.
    pub tests: Option<Tally>,
    /// Why it failed, if it did.
    pub result: Result<(), Trouble>,
    /// How long it took.
    pub took: Duration,
}

impl Outcome {
    /// What the suite adds to the sum: its tests, or itself.
    ///
    /// A suite that failed without a failed test (it was not compiled, say) adds one failure.
    fn counted(&self) -> Tally {
        let tests = self.tests.unwrap_or_default();
        match &self.result {
            Ok(()) if self.tests.is_none() => Tally { passed: 1, failed: 0 },
            Ok(()) => tests,
            Err(_) => Tally { passed: tests.passed, failed: tests.failed.max(1) },
        }
    }

    fn line(&self) -> String {
        let verdict = if self.result.is_ok() { "passed" } else { "failed" };
        let tests = match self.tests {
            Some(Tally { passed: 1, failed: 0 }) => "1 test".into(),
            Some(Tally { passed, failed: 0 }) => format!("{passed} tests"),
            Some(Tally { passed, failed }) => format!("{failed} of {} tests", passed + failed),
            None => String::new(),
        };
        let seconds = self.took.as_secs_f64();
        let mut line = format!("{:<12} {verdict}  {tests:<14} {seconds:>7.1} s", self.name);
        if let Err(trouble) = &self.result {
            let _ = write!(line, "  {}", trouble.lines().next().unwrap_or_default());
        }
        line
    }
}

/// The summary, whose last line is `N passed, N failed`.
pub fn summary(outcomes: &[Outcome]) -> String {
    let mut text = String::new();
    let mut sum = Tally::default();
    for outcome in outcomes {
        sum += outcome.counted();
        let _ = writeln!(text, "{}", outcome.line());
    }
    let _ = write!(text, "\n{} passed, {} failed", sum.passed, sum.failed);
    text
}

#[cfg(test)]
mod tests {
    use super::{Outcome, summary};
    use crate::tally::Tally;
    use std::time::Duration;

    fn outcome(name: &'static str, tests: Option<(u64, u64)>, ok: bool) -> Outcome {
        Outcome {
            name,
            tests: tests.map(|(passed, failed)| Tally { passed, failed }),
            result: if ok { Ok(()) } else { Err("it broke.".into()) },
            took: Duration::from_millis(1500),
        }
    }

    #[test]
    fn a_check_counts_as_one_and_tests_as_themselves() {
        let text = summary(&[outcome("fmt", None, true), outcome("native", Some((40, 2)), false)]);
        assert_eq!(text.lines().last(), Some("41 passed, 2 failed"));
        assert!(text.contains("2 of 42 tests"), "{text}");
    }

    #[test]
    fn a_suite_that_could_not_run_is_a_failure() {
        let text = summary(&[outcome("native", Some((0, 0)), false), outcome("doc", None, false)]);
        assert_eq!(text.lines().last(), Some("0 passed, 2 failed"));
        assert!(text.contains("it broke."), "{text}");
    }
}
