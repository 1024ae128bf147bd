//! TAB-07: a column holds a sign and no digit.

use crate::format::Zeros;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "column-without-digits",
    title: "A column holds a sign and no digit.",
    verdicts: Verdicts::all("TAB-07", Severity::Warning).not_rs274(),
    clauses: &[Clause::Both("3.3.1")],
    page: page!("TAB-07"),
};

/// A column that is quite empty is a word left out, which says no change: that zero was meant cannot be seen.
pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if !word.by_column || word.fault != NumberFault::Empty {
        return;
    }
    let wanted = block.control.designation(word.address).map_or(1, |column| match column.zeros {
        Zeros::All => usize::from(column.width()),
        _ => 1,
    });
    let sign = &block.text[word.range()];
    let zero = format!("{sign}{}", "0".repeat(wanted));
    let message = format!(
        "The column of {} holds a sign and no digit. Without addresses zero is written with at least one zero; an empty \
         column means no change. Write {zero}, or take the sign out.",
        word.letter()
    );
    sink.report(&RULE, word.range(), message).fixes([
        Fix::replace(format!("Write {zero}"), word.range(), zero),
        Fix::replace("Take the sign out", word.range(), ""),
    ]);
}
