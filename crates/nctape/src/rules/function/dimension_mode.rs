//! FUN-03: G90 and G91 stand only where the detail has L.

use crate::format::Sign;
use crate::rules::prelude::*;
use crate::rules::word::repeated::is_repeated;

/// The rule.
pub static RULE: Rule = Rule {
    name: "dimension-mode-fixed",
    title: "G90 and G91 stand only where the detail has L.",
    verdicts: Verdicts::contouring("FUN-03", Severity::Error).not_rs274(),
    clauses: &[Clause::Iso2539("4.2.1"), Clause::Iso2539("D.3.1")],
    page: page!("FUN-03"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some(code @ (90 | 91)) = word.function(b'G') else { return };
    let both = block.control.detail.words.iter().any(|designation| designation.sign == Sign::Both);
    // A second G in its block is the fault then: WORD-05.
    if word.digits == 2 && !both && !is_repeated(word, block) {
        let message = format!(
            "G{code} chooses the kind of dimensions, but the detail fixes it: no dimension word has L. Take G{code} \
             out, or write L in the detail if the control has both kinds."
        );
        sink.report(&RULE, word.range(), message);
    }
}
