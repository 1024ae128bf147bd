//! WORD-21: a tool is called, but no tool change follows.

use crate::read::Block;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "no-tool-change",
    title: "A tool is called, but no tool change follows.",
    verdicts: Verdicts::all("WORD-21", Severity::Info),
    clauses: &[Clause::Both("3.2.3"), Clause::Iso1056("M06")],
    page: page!("WORD-21"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if tape.control.designation(b'M').is_none() || !tape.seen.any(Traits::address(b'T')) {
        return;
    }
    let mut called: Option<(&Block, &Word)> = None;
    let mut unused = Vec::new();
    for (index, block) in tape.reading.blocks.iter().enumerate() {
        if called.is_some_and(|(before, _)| before.program != block.program) {
            unused.extend(called.take());
        }
        if !block.traits.any(Traits::address(b'T').with(Traits::address(b'M'))) {
            continue;
        }
        // A block that is never executed calls no tool.
        if tape.execution.unreached.binary_search(&index).is_ok() {
            continue;
        }
        let words = tape.reading.words(block);
        for word in words.iter().filter(|word| word.address == b'T' && word.value != Some(0)) {
            unused.extend(called.replace((block, word)));
        }
        if words.iter().any(|word| word.function(b'M') == Some(6)) {
            called = None;
        }
    }
    unused.extend(called);
    let Some(&(block, word)) = unused.first() else { return };
    let range = tape.range(block, word);
    let message = format!(
        "The tool {} is called, but no M06 changes it. A tool change acts in its own block only: write M06 each time, \
         unless this control changes the tool with T alone.",
        &tape.text[range.clone()]
    );
    sink.report(&RULE, range, message).count(unused.len());
}
