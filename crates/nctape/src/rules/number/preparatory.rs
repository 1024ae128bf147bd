//! NUM-16: a preparatory function has exactly two digits.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-preparatory-length",
    title: "A preparatory function has exactly two digits.",
    verdicts: Verdicts::all("NUM-16", Severity::Error),
    clauses: &[Clause::Both("3.3.4.2")],
    page: page!("NUM-16"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if word.address != b'G'
        || word.fault != NumberFault::None
        || word.digits == 2
        || block.control.designation(b'G').is_none()
        || super::is_cut_by_letter(word, block)
    {
        return;
    }
    let message = format!("G has {}; a preparatory function has exactly 2.", digits(word.digits));
    let reported = sink.report(&RULE, word.range(), message);
    let text = &block.text[word.range()];
    if word.digits == 1 {
        let padded = format!("{}0{}", &text[..text.len() - 1], &text[text.len() - 1..]);
        reported.fix(|| Fix::replace(format!("Write {padded}"), word.range(), padded));
    }
}
