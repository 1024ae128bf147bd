//! CLD-06: a literal is never closed.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unclosed-literal",
    title: "A literal is never closed.",
    verdicts: Verdicts::cldata("CLD-06", Severity::Error),
    clauses: &[Clause::Iso3592("5.6.1"), Clause::Iso3592("5.7.4")],
    page: page!("CLD-06"),
};

pub(crate) fn check(found: &Slipped, _view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.slip == Slip::Unclosed {
        let end = found.range.end;
        let message = "The literal has no second apostrophe, so that it would take in all that follows. It is taken to \
                       end \
                       here, with the line. Close it; an apostrophe within is written twice.";
        sink.report(&RULE, found.range.clone(), message.to_owned()).fix(|| Fix::replace("Close it", end..end, "'"));
    }
}
