//! WORD-11: digits stand without an address.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "digits-without-address",
    title: "Digits stand without an address.",
    verdicts: Verdicts::all("WORD-11", Severity::Error),
    clauses: &[Clause::Both("C.1.2")],
    page: page!("WORD-11"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if word.address != 0 {
        return;
    }
    let message = if block.control.system == System::Tab {
        "This column is not in the format: it has fewer words than the block has tabs. Take the tab out."
    } else {
        "These digits have no address; in a system with addresses every word begins with one. Put it before them."
    };
    sink.report(&RULE, word.range(), message.to_owned());
}
