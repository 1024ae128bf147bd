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
    let between = || tape.reading.between_blocks(tape.text.len()).any(|gap| tape.text[gap].contains('\t'));
    if tape.control.system != System::Address || !tape.seen.any(Traits::TAB) && !between() {
        return;
    }
    let mut comment = false;
    let tabs = tape.text.bytes().enumerate().filter(|(_, byte)| {
        match byte {
            b'(' => comment = true,
            b')' => comment = false,
            _ => {}
        }
        *byte == b'\t' && !comment
    });
    let tabs: Vec<usize> = tabs.map(|(at, _)| at).collect();
    let (Some(&first), Some(&last)) = (tabs.first(), tabs.last()) else { return };
    sink.report(
        &RULE,
        first..first + 1,
        "The tab has no place here: this is a system with addresses and without tabulation (A). Use blanks for layout, \
         or state a system with tabs (S)."
            .to_owned(),
    )
    .count(tabs.len())
    .fix(|| {
        let mut text = tape.text[first..=last].to_owned().into_bytes();
        tabs.iter().for_each(|at| text[at - first] = b' ');
        Fix::replace("Write blanks", first..last + 1, String::from_utf8(text).unwrap_or_default())
    });
}
