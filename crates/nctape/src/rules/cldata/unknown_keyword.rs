//! CLD-10: the keyword is not among the known words.

use super::prelude::*;
use crate::cldata::nearest;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unknown-keyword",
    title: "The keyword is not among the known words.",
    verdicts: Verdicts::cldata("CLD-10", Severity::Warning),
    clauses: &[Clause::Iso3592("5.11.4")],
    page: page!("CLD-10"),
};

pub(crate) fn check(found: &Slipped, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.slip != Slip::UnknownWord {
        return;
    }
    let letters: String = view.at(&found.range).chars().filter(char::is_ascii_alphabetic).collect();
    let near = nearest(&letters.to_ascii_uppercase());
    let advice = near.map_or("Put a text between apostrophes.".to_owned(), |near| format!("{near} is near it."));
    let message = format!("{} is not among the words that are known of ISO 4343. {advice}", quoted(&letters));
    sink.report(&RULE, found.range.clone(), message)
        .fixes(near.map(|near| Fix::replace(format!("Write {near}"), found.range.clone(), near)));
}
