//! SPEC-24: a field of the format has a value that cannot be used.

use crate::format::FormatDiagnostic;
use crate::format::value::Value;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unusable-format-value",
    title: "A field of the format has a value that cannot be used.",
    verdicts: Verdicts::all("SPEC-24", Severity::Error),
    clauses: &[],
    page: page!("SPEC-24"),
};

/// Reports the value of a field and what is allowed there.
pub(crate) fn report(
    standard: Standard,
    path: &str,
    value: &Value,
    allowed: &str,
    problems: &mut Vec<FormatDiagnostic>,
) {
    let message = format!("{} cannot be used here: {allowed} is. The field is taken as not stated.", value.describe());
    let text = if let Value::Text(text) = value { text.as_str() } else { "" };
    super::report_field(&RULE, standard, (path, text), &message, problems);
}
