//! `cargo xtask test`: runs the suites, goes on after one that fails, and sums up.

use std::process::ExitCode;
use std::time::Instant;

use super::suites::{SUITES, Suite};
use crate::Trouble;
use crate::run::say;
use crate::summary::{Outcome, summary};
use crate::workspace::Workspace;

/// Runs the suites named, or all of them.
pub fn command(workspace: &Workspace, args: &[String]) -> Result<ExitCode, Trouble> {
    let mut outcomes: Vec<Outcome> = Vec::new();
    for suite in chosen(args)? {
        say(&format!("{} ──", suite.name));
        let start = Instant::now();
        let failed = |name: &str| outcomes.iter().any(|done| done.name == name && done.result.is_err());
        let (tests, result) = match suite.needs.filter(|&needed| failed(needed)) {
            Some(needed) => (None, Err(format!("not run, because {needed} failed."))),
            None => (suite.run)(workspace),
        };
        if let Err(trouble) = &result {
            eprintln!("{}: {trouble}", suite.name);
        }
        outcomes.push(Outcome { name: suite.name, tests, result, took: start.elapsed() });
    }
    say("Summary ──");
    println!("{}", summary(&outcomes));
    let all_passed = outcomes.iter().all(|outcome| outcome.result.is_ok());
    Ok(ExitCode::from(u8::from(!all_passed)))
}

/// The names of the suites.
pub fn names() -> Vec<&'static str> {
    SUITES.iter().map(|suite| suite.name).collect()
}

/// The suites named and those that they need, in the order of `SUITES`.
fn chosen(args: &[String]) -> Result<Vec<&'static Suite>, Trouble> {
    if let Some(unknown) = args.iter().find(|arg| !names().contains(&arg.as_str())) {
        return Err(format!("there is no suite `{unknown}`. The suites are {}.", names().join(", ")));
    }
    let mut wanted: Vec<&str> = if args.is_empty() { names() } else { args.iter().map(String::as_str).collect() };
    // What a suite needs stands before it, so one pass from the end finds all of it.
    for suite in SUITES.iter().rev() {
        if wanted.contains(&suite.name) {
            wanted.extend(suite.needs);
        }
    }
    Ok(SUITES.iter().filter(|suite| wanted.contains(&suite.name)).collect())
}

#[cfg(test)]
mod tests {
    use super::chosen;

    fn names(args: &[&str]) -> Option<Vec<&'static str>> {
        let args: Vec<String> = args.iter().map(ToString::to_string).collect();
        let suites = chosen(&args).ok()?;
        Some(suites.iter().map(|suite| suite.name).collect())
    }

    #[test]
    fn a_suite_brings_what_it_needs() {
        assert_eq!(names(&["fmt"]), Some(vec!["fmt"]));
        assert_eq!(names(&["e2e"]), Some(vec!["package", "site", "e2e"]));
        assert_eq!(names(&["node", "fmt"]), Some(vec!["fmt", "package", "node"]));
    }

    #[test]
    fn without_names_all_of_them_run() {
        assert_eq!(names(&[]).map(|all| all.len()), Some(super::SUITES.len()));
        assert_eq!(names(&["everything"]), None);
    }
}
