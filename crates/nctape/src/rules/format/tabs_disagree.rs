//! SPEC-10: the full stops of the detail and the system letter disagree.

use crate::format::{Designation, Detail};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tabs-disagree",
    title: "The full stops of the detail and the system letter disagree.",
    verdicts: Verdicts::all("SPEC-10", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("D.1"), Clause::Both("C.1.2"), Clause::Both("3.3.2")],
    page: page!("SPEC-10"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    let Some(system) = control.classification.as_ref().and_then(|found| found.system()) else { return };
    let wrong = |tab: bool| match system {
        System::Address => tab,
        System::Tab | System::TabAndAddress => !tab,
    };
    // What stands in place of the full stop is the fault then.
    let is_wrong = |index: usize, word: &Designation| match word.address {
        'N' => word.tab,
        _ => wrong(word.tab) && (word.tab || !detail.is_behind_stray(index)),
    };
    let Some((_, word)) = detail.words.iter().enumerate().find(|(index, word)| is_wrong(*index, word)) else { return };
    let message = match system {
        _ if word.address == 'N' => {
            format!("A full stop stands before {}, but the sequence number has no tab before it.", word.text())
        }
        System::Address => format!("A full stop stands before {}, but system A has no tabs.", word.text()),
        _ => format!("No full stop stands before {}, but system {} has tabs.", word.text(), system.letter()),
    };
    sink.report(&RULE, word.range.clone(), message);
}
