//! TAB-02: a number stands in the column beside its own.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "wrong-column",
    title: "A number has the shape of the column beside its own.",
    verdicts: Verdicts::all("TAB-02", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("3.2.3")],
    page: page!("TAB-02"),
};

/// The scanner found the fault; here it is said which column fits. A number that happens to fit its wrong column cannot
/// be told from one that is meant.
pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if word.fault != NumberFault::Column {
        return;
    }
    let words = &block.control.detail.words;
    let Some(column) = words.iter().position(|column| column.address == word.letter()) else { return };
    let at = word.range().start;
    let text = &block.text[word.range()];
    let own = &words[column];
    // A number right behind another one: the scanner took it to the next column.
    if word.tabs == 0 && word.from > 0 {
        let message = format!(
            "{text} follows another number without a tab; it has the shape of {} ({}): a tab is probably missing before it.",
            own.address,
            own.text()
        );
        sink.report(&RULE, word.range(), message).fix(|| Fix::replace("Put a tab before it", at..at, "\t"));
        return;
    }
    let lost = words.get(column + 1).filter(|next| next.fits(word.sign, word.digits));
    let (other, what) = match (lost, column.checked_sub(1).map(|before| &words[before])) {
        (Some(next), _) => (next, "a tab is probably missing before it"),
        (None, Some(before)) => (before, "there is probably a tab too many before it"),
        (None, None) => return,
    };
    let message = format!(
        "{text} stands in the column of {} ({}), but has the shape of {} ({}): {what}.",
        own.address,
        own.text(),
        other.address,
        other.text()
    );
    let tab = block.text[..at].rfind('\t');
    sink.report(&RULE, word.range(), message).fixes(match (lost, tab) {
        (Some(_), _) => Some(Fix::replace("Put a tab before it", at..at, "\t")),
        (None, Some(tab)) => Some(Fix::replace("Take a tab out", tab..tab + 1, "")),
        (None, None) => None,
    });
}
