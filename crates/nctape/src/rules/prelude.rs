//! What the files of the rules use.

pub(crate) use super::view::TapeView;
pub(crate) use super::{Clause, Rule, Verdicts};
pub(crate) use crate::code::Code;
pub(crate) use crate::diagnostic::{Fix, Severity, Sink};
pub(crate) use crate::format::{Control, Standard, System};
pub(crate) use crate::read::{BlockView, NumberFault, Word};

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
    let declared = control.format.itemized.declared.as_ref();
    declared.is_some_and(|declared| declared.letters.contains_key(&letter.to_string()))
}
