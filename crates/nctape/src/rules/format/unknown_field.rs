//! SPEC-23: the format has a field that is not known.

use crate::format::FormatDiagnostic;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unknown-format-field",
    title: "The format has a field that is not known.",
    verdicts: Verdicts::all("SPEC-23", Severity::Warning),
    clauses: &[],
    page: page!("SPEC-23"),
};

/// Reports a field by its path.
pub(crate) fn report(standard: Standard, path: &str, problems: &mut Vec<FormatDiagnostic>) {
    super::report_field(
        &RULE,
        standard,
        (path, ""),
        "There is no such field in a format; it decides nothing.",
        problems,
    );
}
