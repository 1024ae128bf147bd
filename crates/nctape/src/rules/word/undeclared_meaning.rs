//! WORD-16: the detail has a letter of several meanings, and none is named.

use crate::format::{Designation, Detail};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "undeclared-meaning",
    title: "The detail has a letter of several meanings, and none is named.",
    verdicts: Verdicts::all("WORD-16", Severity::Error),
    clauses: &[Clause::Both("B.1 note 1")],
    page: page!("WORD-16"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    // compensation: true or false says what P, Q and R are.
    let stated = |letter: char| "PQR".contains(letter) && control.format.itemized.compensation.is_some();
    for word in &detail.words {
        let Some(meaning) = meaning(word) else { continue };
        if stated(word.address) || is_declared_letter(word.address, control) {
            continue;
        }
        let letter = word.address;
        let message =
            format!("{letter} has more than one possible meaning. Name the one that it has here, such as: {meaning}.");
        sink.report(&RULE, word.range.clone(), message).fix(|| {
            let mut format = control.format.clone();
            let declared = format.itemized.declared.get_or_insert_default();
            declared.letters.insert(letter.to_string(), meaning.to_owned());
            Fix::reformat(format!("Declare it: {meaning}"), format)
        });
    }
}

/// The meaning that annex B names first for such a word; `None` for the other letters.
fn meaning(word: &Designation) -> Option<&'static str> {
    Some(match (word.address, word.dimension) {
        ('D', false) => "third feed function",
        ('E', false) => "second feed function",
        ('D' | 'E', true) => "angular dimension about a special axis",
        ('P', _) => "tertiary motion parallel to X",
        ('Q', _) => "tertiary motion parallel to Y",
        ('R', _) => "tertiary motion parallel to Z",
        ('U', _) => "secondary motion parallel to X",
        ('V', _) => "secondary motion parallel to Y",
        ('W', _) => "secondary motion parallel to Z",
        _ => return None,
    })
}
