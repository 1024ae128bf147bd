//! TAB-05: some words of the tape begin with a tab, some do not.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "mixed-tabs",
    title: "Some words of the tape begin with a tab, some do not.",
    verdicts: Verdicts::contouring("TAB-05", Severity::Info),
    clauses: &[Clause::Iso2539("C.1.2")],
    page: page!("TAB-05"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.control.system != System::TabAndAddress || !tape.seen.any(Traits::TAB) {
        return;
    }
    let mut words = tape.words().filter(|(_, word)| !word.is_sequence() && word.address != 0);
    let Some((_, first)) = words.next() else { return };
    let with_tab = first.tabs > 0;
    let mut others = words.filter(|(_, word)| (word.tabs > 0) != with_tab);
    let Some((block, other)) = others.next() else { return };
    let (before, here) = if with_tab { ("begin with a tab", "does not") } else { ("have no tab", "has one") };
    let message = format!(
        "Words before this one {before}, {} {here}. Both are allowed in a system with optional tabs; on one tape it \
         may be a slip.",
        other.letter()
    );
    sink.report(&RULE, tape.range(block, other), message).count(1 + others.count());
}
