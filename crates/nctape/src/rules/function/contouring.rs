//! FUN-08: a positioning control does not contour.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "contouring-on-positioning-control",
    title: "A positioning control does not contour.",
    verdicts: Verdicts::positioning("FUN-08", Severity::Error),
    clauses: &[Clause::Iso1058("1.1")],
    page: page!("FUN-08"),
};

pub(crate) fn check(word: &Word, _: &BlockView<'_>, sink: &mut Sink<'_>) {
    if let (Some(code @ (2 | 3 | 6)), 2) = (word.function(b'G'), word.digits) {
        let message = format!(
            "G{code:02} contours; ISO 1058 is for positioning and cutting parallel to the axes. A contouring control \
             follows ISO 2539."
        );
        sink.report(&RULE, word.range(), message);
    }
}
