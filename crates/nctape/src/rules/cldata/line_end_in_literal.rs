//! CLD-07: a literal goes over a line end.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "line-end-in-literal",
    title: "A literal goes over a line end.",
    verdicts: Verdicts::cldata("CLD-07", Severity::Warning),
    clauses: &[Clause::Iso3592("5.7.4")],
    page: page!("CLD-07"),
};

/// The record size that annex A names.
const COLUMNS: usize = 72;

pub(crate) fn check(found: &Slipped, _view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Slip::LineEnd { width } = found.slip else { return };
    let hint = if width >= COLUMNS {
        format!(
            " The line has {width} columns: if the file has records of {COLUMNS} columns, read it so, and the literal \
             goes on in the first column."
        )
    } else {
        String::new()
    };
    let message = format!(
        "In a stream the line end is part of the literal. Close the literal on its line if that is not meant.{hint}"
    );
    sink.report(&RULE, found.range.clone(), message);
}
