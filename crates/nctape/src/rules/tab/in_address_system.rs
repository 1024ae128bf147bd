//! TAB-01: a system without tabulation has no tabs.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tab-in-address-system",
    title: "A system without tabulation has no tabs.",
    verdicts: Verdicts::all("TAB-01", Severity::Error),
    clauses: &[Clause::Both("C.1.2")],
    page: page!("TAB-01"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.control.system != System::Address {
        return;
    }
    let mut comment = false;
    let mut tabs = tape.text.bytes().enumerate().filter(|(_, byte)| {
        match byte {
            b'(' => comment = true,
            b')' => comment = false,
            _ => {}
        }
        *byte == b'\t' && !comment
    });
    let Some((at, _)) = tabs.next() else { return };
    sink.report(
        &RULE,
        at..at + 1,
        "A tab; this is a system with addresses and without tabulation (A). Use blanks for layout, or state a system \
         with tabs (S)."
            .to_owned(),
    )
    .count(1 + tabs.count());
}
