//! CLD-03: the character has no meaning outside of a literal.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "meaningless-character",
    title: "The character has no meaning outside of a literal.",
    verdicts: Verdicts::cldata("CLD-03", Severity::Warning),
    clauses: &[Clause::Iso3592("5.5")],
    page: page!("CLD-03"),
};

pub(crate) fn check(found: &Slipped, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.slip == Slip::Meaningless {
        let message = format!(
            "{} has no meaning outside of a literal and is passed over. Elements are made of letters, digits, + - . \
             and \
             apostrophes. Take it out, or put it between apostrophes.",
            quoted(view.at(&found.range))
        );
        sink.report(&RULE, found.range.clone(), message).fix(|| Fix::replace("Take it out", found.range.clone(), ""));
    }
}
