//! ROW-01: a row has the wrong parity.

use crate::code::Code;
use crate::rules::prelude::{Clause, Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-parity",
    title: "A row has the wrong parity.",
    verdicts: Verdicts::all("ROW-01", Severity::Error),
    clauses: &[Clause::Both("1.5")],
    page: page!("ROW-01"),
};

/// What is said of a row.
pub(crate) fn message(row: u8, code: Code) -> String {
    let parity = if code == Code::Iso { "even" } else { "odd" };
    let near: Vec<String> = (0..8)
        .filter_map(|track| code.meaning(row ^ (1 << track)))
        .map(|(label, _)| label)
        .filter(|label| !label.is_empty())
        .collect();
    let near = if near.is_empty() { String::new() } else { format!(" One hole away from it: {}.", near.join(", ")) };
    format!(
        "The row has {}; {} has an {parity} number of holes in every row.{near} Punch the character anew.",
        super::tracks(row),
        code.name()
    )
}
