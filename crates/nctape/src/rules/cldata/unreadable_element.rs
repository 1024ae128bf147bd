//! CLD-08: the element is no number, literal or keyword.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "unreadable-element",
    title: "The element is no number, literal or keyword.",
    verdicts: Verdicts::cldata("CLD-08", Severity::Error),
    clauses: &[Clause::Iso3592("5.13.1")],
    page: page!("CLD-08"),
};

pub(crate) fn check(found: &Slipped, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Slip::Unreadable(why) = found.slip else { return };
    let what = match why {
        Unreadable::NoPoint(_) => {
            "has an exponent but no decimal point: only a real number has one. Put a point before the E"
        }
        Unreadable::Number => {
            "is no number: digits with a sign before and at most one decimal point, and behind a real number E and an \
             integer"
        }
        Unreadable::OneLetter => {
            "is one letter; a keyword has two or more. Write the keyword, or put a text between apostrophes"
        }
        Unreadable::DigitInWord => "has a digit; a keyword is made of letters alone. Put a text between apostrophes",
        Unreadable::BesideLiteral => {
            "has something beside a literal. Put a comma between them; an apostrophe within a literal is written twice"
        }
        Unreadable::Foreign => return,
    };
    let message = format!("{} {what}.", quoted(view.at(&found.range)));
    let fix = match why {
        Unreadable::NoPoint(at) => Some(Fix::replace("Put a point", at..at, ".")),
        _ => None,
    };
    sink.report(&RULE, found.range.clone(), message).fixes(fix);
}
