//! SPEC-10: the full stops of the detail and the system letter disagree.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tabs-disagree",
    title: "The full stops of the detail and the system letter disagree.",
    verdicts: Verdicts::all("SPEC-10", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("D.1"), Clause::Both("C.1.2")],
    page: page!("SPEC-10"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    let Some(system) = control.classification.as_ref().and_then(|found| found.system()) else { return };
    let wrong = |tab: bool| match system {
        System::Address => tab,
        System::Tab | System::TabAndAddress => !tab,
    };
    // The sequence number word has no tab (3.3.2).
    let words = detail.words.iter().filter(|word| word.address != 'N');
    let Some(word) = words.into_iter().find(|word| wrong(word.tab)) else { return };
    let message = match system {
        System::Address => format!("A full stop stands before {}, but system A has no tabs.", word.text()),
        _ => format!("No full stop stands before {}, but system {} has tabs.", word.text(), system.letter()),
    };
    sink.report(&RULE, word.range.clone(), message);
}
