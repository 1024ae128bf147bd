//! CLD-01: the statement is of a part program, not of CLDATA.

use super::prelude::*;
use crate::rules::foreign_text::in_records;
use std::ops::Range;

/// The rule.
pub static RULE: Rule = Rule {
    name: "apt-source",
    title: "The statement is of a part program, not of CLDATA.",
    verdicts: Verdicts::cldata("CLD-01", Severity::Error),
    clauses: &[Clause::Iso3592("5.4"), Clause::Iso3592("5.12")],
    page: page!("CLD-01"),
};

/// Says that a text is the source of a part program and nothing else.
pub(crate) fn check_text(text: &str, found: (Range<usize>, usize), sink: &mut Sink<'_>) {
    let message = "The text is APT source, which a processor reads and turns into CLDATA: a statement is WORD/ and its \
                   parameters. In CLDATA this would be a record, as 2,20000,0,FEDRAT,10.,PERMIN; and the text is to be \
                   run through the processor first. Nothing else is checked.";
    sink.report(&RULE, found.0, message.to_owned()).count(found.1).fixes(in_records(text, "Turn it into records"));
}

pub(crate) fn check(found: &Slipped, _view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let (message, title, insert) = match found.slip {
        Slip::Remark => (
            "$$ begins a remark in APT source; CLDATA has none. Take it out, or put it in a PPRINT.",
            "Take it out",
            "",
        ),
        Slip::Continuation => (
            "$ makes a statement of APT go on in the next line; a record goes on until its ; and needs none. Take it \
             out.",
            "Take it out",
            "",
        ),
        Slip::Slash => (
            "/ stands behind the word of an APT statement; in a record a comma separates the elements.",
            "Put a comma",
            ",",
        ),
        _ => return,
    };
    sink.report(&RULE, found.range.clone(), message.to_owned())
        .fix(|| Fix::replace(title, found.range.clone(), insert));
}
