//! CLD-05: a keyword has small letters.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "lower-case-keyword",
    title: "A keyword has small letters.",
    verdicts: Verdicts::cldata("CLD-05", Severity::Error),
    clauses: &[Clause::Iso3592("5.2.3"), Clause::Iso3592("5.11.3")],
    page: page!("CLD-05"),
};

pub(crate) fn check(found: &Slipped, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.slip == Slip::LowerCase {
        let word = view.at(&found.range);
        let message = format!(
            "{} has small letters; the letters of a keyword are A to Z. It is read as {}.",
            quoted(word),
            word.to_ascii_uppercase()
        );
        sink.report(&RULE, found.range.clone(), message)
            .fix(|| Fix::replace("Write it in capital letters", found.range.clone(), word.to_ascii_uppercase()));
    }
}
