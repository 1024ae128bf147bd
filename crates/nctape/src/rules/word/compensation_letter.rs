//! WORD-17: tool compensation has a word of its own that is not D, or a D without a place.

use crate::format::{Detail, FormatDiagnostic};
use crate::rules::format::report_field;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tool-compensation-apart",
    title: "Tool compensation has a word that is not D, or a D without a place.",
    verdicts: Verdicts::contouring("WORD-17", Severity::Warning),
    clauses: &[Clause::Iso2539("3.3.4.5")],
    page: page!("WORD-17"),
};

/// The letters but T that the itemized data declares to select tool compensation.
fn letters(control: &Control) -> impl Iterator<Item = char> {
    ('A'..='Z').filter(|&letter| {
        let meaning = declared_letter(letter, control).unwrap_or("").to_lowercase();
        letter != 'T' && meaning.contains("tool") && (meaning.contains("compensation") || meaning.contains("offset"))
    })
}

fn message(letter: char) -> String {
    format!(
        "{letter} is declared to select the tool compensation. The last digits of T should select it (compensationDigits); \
         a word of its own should be D."
    )
}

/// A letter of the detail.
pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    for letter in letters(control).filter(|letter| *letter != 'D') {
        if let Some(word) = detail.words.iter().find(|word| word.address == letter) {
            sink.report(&RULE, word.range.clone(), message(letter));
        }
    }
}

/// A letter that the detail lacks: its place in a block is open too.
pub(crate) fn check_itemized(control: &Control, problems: &mut Vec<FormatDiagnostic>) {
    for letter in letters(control).filter(|letter| control.designation(*letter as u8).is_none()) {
        let message = match letter {
            'D' => {
                "D is declared to select the tool compensation, but its place in a block is not stated. Write it into \
                    the detail, such as T2D2."
                    .to_owned()
            }
            _ => message(letter),
        };
        report_field(&RULE, control.standard(), ("itemized.declared", ""), &message, problems);
    }
}
