//! SPEC-11: the detail does not end with an asterisk.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "missing-asterisk",
    title: "The detail does not end with an asterisk.",
    verdicts: Verdicts::all("SPEC-11", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("D.2")],
    page: page!("SPEC-11"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    if detail.end.is_none() {
        let at = detail.length;
        sink.report(&RULE, at..at, "The detail ends with an asterisk, which stands for the end of block.".to_owned())
            .fix(|| {
                let mut format = control.format.clone();
                format.detail.push('*');
                Fix::reformat("Put an asterisk at the end", format)
            });
    }
}
