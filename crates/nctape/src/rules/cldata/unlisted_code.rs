//! CLD-27: the integer code is of no known word.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unlisted-code",
    title: "The integer code is of no known word.",
    verdicts: Verdicts::cldata("CLD-27", Severity::Warning),
    clauses: &[Clause::Iso3592("6.3")],
    page: page!("CLD-27"),
};

pub(crate) fn check(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if let Event::UnlistedCode { code } = found.event {
        let message = format!(
            "No word with the code {code} is known. In a record of type 2000 words are integers and numbers are real: \
             if it \
             is a number, it wants a decimal point."
        );
        sink.report(&RULE, view.event(found), message);
    }
}
