//! TAB-03: a block has more tabs than the format has words.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "too-many-tabs",
    title: "A block has more tabs than the format has words.",
    verdicts: Verdicts::all("TAB-03", Severity::Error),
    clauses: &[Clause::Both("annex D")],
    page: page!("TAB-03"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let Some((tabs, allowed)) = surplus(block) else { return };
    let message = format!(
        "The tab begins no word of the format, which has words for {allowed} tabs; the block has {}. Take out those that \
         are too many.",
        tabs.len()
    );
    let first = tabs[allowed];
    let idle = block.words.last().is_none_or(|word| word.range().end <= first);
    sink.report(&RULE, first..first + 1, message).fixes(
        idle.then(|| {
            Fix::edits("Take the last tabs out", tabs[allowed..].iter().map(|&at| (at..at + 1, String::new())))
        }),
    );
}

/// The tabs of the block and how many it may have, where it has more.
pub(crate) fn surplus(block: &BlockView<'_>) -> Option<(Vec<usize>, usize)> {
    let words = &block.control.detail.words;
    if block.control.system == System::Address || words.is_empty() || !block.tab {
        return None;
    }
    // A tab before the sequence number word is a fault of its own: SEQ-06.
    let idle = block.sequence().map_or(0, |word| usize::from(word.tabs));
    let tabs = super::tabs(block).split_off(idle);
    // A word that may come again has its tab again: several tool words (ISO 2539), several miscellaneous words (ISO
    // 1058), a second feed word.
    let again = block.words.windows(2).filter(|pair| pair[0].address == pair[1].address);
    let again: usize =
        again.filter(|pair| b"FTM".contains(&pair[1].address)).map(|pair| usize::from(pair[1].tabs)).sum();
    let allowed = words.iter().filter(|word| word.address != 'N').count() + again;
    (tabs.len() > allowed).then_some((tabs, allowed))
}
