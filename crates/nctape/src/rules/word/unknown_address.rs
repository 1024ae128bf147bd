//! WORD-12: an address is not in the format detail.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "address-not-in-format",
    title: "An address is not in the format detail.",
    verdicts: Verdicts::all("WORD-12", Severity::Error),
    clauses: &[Clause::Both("D.3")],
    page: page!("WORD-12"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    let control = block.control;
    if control.detail.words.is_empty()
        || word.address == 0
        || super::is_known(word, control)
        || super::has_rule_of_its_own(word, control)
    {
        return;
    }
    let words: Vec<String> = control.detail.words.iter().map(|designation| designation.text()).collect();
    let message = format!(
        "The address {} is not in the format, which has {}. Take the word out, or state it in the detail.",
        word.letter(),
        words.join(" ")
    );
    sink.report(&RULE, word.range(), message);
}

/// A detail that names no word has no address at all: a fault of the format, which is said once.
pub(crate) fn check_tape(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let control = tape.control;
    if !control.detail.words.is_empty() {
        return;
    }
    let is_lost = |word: &Word| word.address != 0 && !super::has_rule_of_its_own(word, control);
    let mut lost = tape.words().filter(|(_, word)| is_lost(word));
    if let Some((block, word)) = lost.next() {
        let message =
            "The detail of the format names no word, so that no address is in it. State the words in the format.";
        sink.report(&RULE, tape.range(block, word), message.to_owned()).count(1 + lost.count());
    }
}

#[cfg(test)]
mod tests {
    use crate::{Format, Standard, Tape};

    #[test]
    fn a_detail_without_words_is_said_once() {
        for standard in [Standard::Iso2539, Standard::Iso1058, Standard::Rs274] {
            let tape = Tape::new("%\nN001 G01 X+001000\nN002 M30\n", &Format::new(standard, ""));
            let found = tape.diagnostics();
            let lost: Vec<_> = found.iter().filter(|found| found.id == "WORD-12").collect();
            assert_eq!(lost.len(), 1, "{found:?}");
            assert_eq!((lost[0].range.clone(), lost[0].count), (2..6, 5));
            assert!(found.iter().all(|found| found.id == "WORD-12"), "{found:?}");
        }
    }
}
