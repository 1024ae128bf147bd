//! TAPE-08: a character is not one of the tape.

use crate::read::{Stray, StrayKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "foreign-character",
    title: "A character is not one of the tape.",
    verdicts: Verdicts::all("TAPE-08", Severity::Error),
    clauses: &[Clause::Both("annex B")],
    page: page!("TAPE-08"),
};

/// Characters of the strays of a block, or of what stands before the first one.
pub(crate) fn check(strays: &[Stray], control: &Control, sink: &mut Sink<'_>) {
    let code = match control.code {
        Code::Iso => "ISO 840",
        Code::Eia => "EIA RS-244",
    };
    for stray in strays {
        match stray.kind {
            StrayKind::Foreign(character) => {
                let reported = sink.report(
                    &RULE,
                    stray.range(),
                    format!(
                        "{} is not one of the format; words are made of capital letters, digits and the signs + and -. {}",
                        named(character),
                        advice(character)
                    ),
                );
                if let Some(meant) = look_alike(character) {
                    let title = if meant == " " { "Write a blank".to_owned() } else { format!("Write {meant}") };
                    reported.fix(|| Fix::replace(title, stray.range(), meant));
                }
            }
            StrayKind::InComment(character) => {
                sink.report_as(
                    Severity::Info,
                    &RULE,
                    stray.range(),
                    format!("{} has no row in {code}: it is left out of the comment on the tape.", named(character)),
                );
            }
            _ => {}
        }
    }
}

/// A character as it can be shown.
fn named(character: char) -> String {
    if character.is_control() || character.is_whitespace() || u32::from(character) >= 0x80 {
        format!("The character U+{:04X}", u32::from(character))
    } else {
        format!("The character {character}")
    }
}

/// What a text editor may have put in place of a character of the tape.
fn look_alike(character: char) -> Option<&'static str> {
    match character {
        '\u{2212}' | '\u{2010}'..='\u{2014}' => Some("-"),
        '\u{00A0}' | '\u{2007}' | '\u{202F}' => Some(" "),
        _ => None,
    }
}

fn advice(character: char) -> &'static str {
    if look_alike(character).is_some() { "It looks like one that is: write that." } else { "Take it out." }
}
