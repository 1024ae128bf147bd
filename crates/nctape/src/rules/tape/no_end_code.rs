//! TAPE-10: the program has no end code.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "no-program-end",
    title: "The program has no end code.",
    verdicts: Verdicts::all("TAPE-10", Severity::Warning),
    clauses: &[Clause::Iso1056("M02, M30")],
    page: page!("TAPE-10"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    for &(last, ended) in &tape.execution.ends {
        if !ended {
            sink.report(
                &RULE,
                tape.extent(last),
                "The program has no M02 or M30: the control runs out of tape here. End it with M02, or with M30 to \
                 rewind."
                    .to_owned(),
            );
        }
    }
}
