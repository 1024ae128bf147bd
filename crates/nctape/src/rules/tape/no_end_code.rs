//! TAPE-10: the program has no end code.

use crate::rules::comment::swallowed;
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
    if tape.reading.blocks.is_empty() && !tape.ends_in_comment() {
        sink.report(
            &RULE,
            0..0,
            "There is no block on this tape, and so no M02 or M30 that ends a program. Type or paste one, such as \
             N001 M30."
                .to_owned(),
        );
    }
    let mut first = 0;
    for &(last, ended) in &tape.execution.ends {
        let program = std::mem::replace(&mut first, last + 1)..last + 1;
        let end = last;
        // Behind a comment that nothing closes there may be one: CTRL-01.
        if ended || last + 1 == tape.reading.blocks.len() && tape.ends_in_comment() {
            continue;
        }
        // What holds no word is no program, unless there is nothing else.
        let start = program.start;
        let holds_word = |index: &usize| !tape.reading.words(&tape.reading.blocks[*index]).is_empty();
        let last = match program.rev().find(holds_word) {
            Some(last) => last,
            None if start > 0 => continue,
            None => last,
        };
        let block = &tape.reading.blocks[last];
        let words = tape.reading.words(block);
        // An M that cannot be read may be one, and so may digits in a wrong column or without an address: each is
        // reported itself.
        let lost = |word: &Word| word.address == b'M' && word.value.is_none() || word.fault == NumberFault::Column;
        if words.iter().any(|word| lost(word) || word.address == 0) || is_swallowed(tape, start, end) {
            continue;
        }
        let reported = sink.report(
            &RULE,
            tape.extent(last),
            "The program has no M02 or M30: the control runs out of tape here. End it with M02, or with M30 to rewind."
                .to_owned(),
        );
        // One M word for each block, and it is the last word.
        let writable = tape.control.system == System::Address && tape.control.designation(b'M').is_some();
        if let Some(word) = words.last().filter(|_| writable && words.iter().all(|word| word.address != b'M')) {
            let at = tape.range(block, word).end;
            reported.fix(|| Fix::replace("End it with M30", at..at, " M30"));
        }
    }
}

/// A comment that swallowed blocks of the program swallowed an M02 or M30 with them: CTRL-06.
fn is_swallowed(tape: &TapeView<'_>, first: usize, last: usize) -> bool {
    let (from, to) = (tape.reading.blocks[first].range.start, tape.reading.blocks[last].range.end);
    let found = tape.reading.found().iter().filter(|found| std::ptr::eq(found.diagnostic.rule, &swallowed::RULE));
    let mut comments =
        found.map(|found| found.origin + found.diagnostic.range.start).filter(|at| (from..to).contains(at));
    comments.any(|at| {
        let comment = tape.text[at..].split(')').next().unwrap_or("");
        comment.match_indices(['M', 'm']).any(|(at, _)| {
            let behind = comment[at + 1..].trim_start_matches(' ');
            let digits = behind.len() - behind.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            matches!(&behind[..digits], "02" | "2" | "30")
        })
    })
}
