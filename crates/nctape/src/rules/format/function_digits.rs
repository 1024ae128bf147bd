//! SPEC-15: a letter that is no dimension has not one digit.

use crate::format::{DIMENSION_LETTERS, Designation, Detail, Sign};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-function-designation",
    title: "A letter that is no dimension has not one digit.",
    verdicts: Verdicts::all("SPEC-15", Severity::Error),
    clauses: &[Clause::Both("D.3.2")],
    page: page!("SPEC-15"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for word in &detail.words {
        // What cuts the digits short is the fault then.
        if DIMENSION_LETTERS.contains(word.address) || detail.is_cut_short(word) {
            continue;
        }
        // Y-1702 gives the feed of RS-274 a decimal sign: f21.
        let eia = control.standard() == Standard::Rs274;
        let fits = word.digits.len() == 1 || eia && word.address == 'F' && word.digits.len() == 2;
        let what = match word.sign {
            _ if !fits => format!("has {}", digits(word.digits.len() as u16)),
            Sign::Positive if word.width() == 0 && !has_rule_of_its_own(word) => "is a word without digits".to_owned(),
            Sign::Positive => continue,
            _ => "has a sign mark, but such a word has no sign".to_owned(),
        };
        let allowed = if eia { "F4; F21 for a feed with a decimal sign" } else { "F4" };
        let message = format!(
            "{} {what}; the address of a word that is no dimension has one digit, the count of its digits ({allowed}).",
            word.text()
        );
        sink.report(&RULE, word.range.clone(), message);
    }
}

/// N, G and M have a count of digits of their own: SPEC-16 to SPEC-18.
fn has_rule_of_its_own(word: &Designation) -> bool {
    matches!(word.address, 'N' | 'G' | 'M')
}
