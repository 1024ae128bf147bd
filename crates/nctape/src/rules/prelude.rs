//! What the files of the rules use.

pub(crate) use super::view::TapeView;
pub(crate) use super::{Clause, Rule, Verdicts};
pub(crate) use crate::code::Code;
pub(crate) use crate::diagnostic::{Fix, Severity, Sink};
pub(crate) use crate::format::{Control, Standard, System};
pub(crate) use crate::order::order_by_key;
pub(crate) use crate::read::{BlockView, NumberFault, Traits, Word};

/// The page of a rule: Markdown, run as its test.
macro_rules! page {
    ($id:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/rules/", $id, ".md"))
    };
}
pub(crate) use page;

/// "1 digit", "4 digits".
pub(crate) fn digits(count: u16) -> String {
    if count == 1 { "1 digit".to_owned() } else { format!("{count} digits") }
}

/// The itemized data gives the address of a word a meaning.
pub(crate) fn is_declared(word: &Word, control: &Control) -> bool {
    is_declared_letter(word.letter(), control)
}

/// The itemized data gives an address letter a meaning.
pub(crate) fn is_declared_letter(letter: char, control: &Control) -> bool {
    declared_letter(letter, control).is_some()
}

/// The meaning that the itemized data gives an address letter.
pub(crate) fn declared_letter(letter: char, control: &Control) -> Option<&str> {
    let declared = control.format.itemized.declared.as_ref()?;
    declared.letters.get(letter.encode_utf8(&mut [0; 4])).map(String::as_str)
}

/// A fix that moves a word before another of its block; none where tabs belong to the words.
pub(crate) fn move_before(word: &Word, other: &Word, block: &BlockView<'_>) -> Option<Fix> {
    if block.words.iter().any(|word| word.tabs > 0) || other.from >= word.from {
        return None;
    }
    let (to, from) = (other.range().start, word.range());
    let text = &block.text[from.clone()];
    let blanks = block.text[..from.start].len() - block.text[..from.start].trim_end_matches(' ').len();
    let insert = if blanks > 0 { format!("{text} ") } else { text.to_owned() };
    let title = format!("Move it before {}", &block.text[other.range()]);
    Some(Fix::edits(title, [(to..to, insert), (from.start - blanks..from.end, String::new())]))
}

/// A fix that puts words of a block into another order, each in the place of another; none where tabs belong to them.
pub(crate) fn reorder(words: &[&Word], ordered: &[&Word], block: &BlockView<'_>) -> Option<Fix> {
    if block.words.iter().any(|word| word.tabs > 0) {
        return None;
    }
    let moved = words.iter().zip(ordered).filter(|(word, ordered)| word.from != ordered.from);
    let edits = moved.map(|(word, ordered)| (word.range(), block.text[ordered.range()].to_owned()));
    Some(Fix::edits("Put the words in order", edits))
}
