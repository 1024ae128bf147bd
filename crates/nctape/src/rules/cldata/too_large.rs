//! CLD-11: the number is too large to be computed with.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "number-out-of-range",
    title: "The number is too large to be computed with.",
    verdicts: Verdicts::cldata("CLD-11", Severity::Error),
    clauses: &[Clause::Iso3592("5.9.3"), Clause::Iso3592("5.10.3")],
    page: page!("CLD-11"),
};

const MESSAGE: &str =
    "This is too large a number for a place or a value: it is not computed with. Correct its exponent or its digits.";

pub(crate) fn check(found: &Slipped, _view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.slip == Slip::TooLarge {
        sink.report(&RULE, found.range.clone(), MESSAGE.to_owned());
    }
}

pub(crate) fn check_event(found: &Noted, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    if found.event == Event::TooFar {
        sink.report(&RULE, view.event(found), MESSAGE.to_owned());
    }
}
