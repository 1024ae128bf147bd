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
    let mut at = 0;
    while let Some(stray) = strays.get(at) {
        at += 1;
        match stray.kind {
            StrayKind::Foreign(character) => {
                // What stands together is said once.
                let joined =
                    |pair: &[Stray]| pair[0].to == pair[1].from && matches!(pair[1].kind, StrayKind::Foreign(_));
                let more = strays[at - 1..].windows(2).take_while(|pair| joined(pair)).count();
                at += more;
                let range = stray.range().start..strays[at - 1].range().end;
                let message = format!(
                    "{} is not one of the format; words are made of capital letters, digits and the signs + and -. {}",
                    named(character),
                    advice(character)
                );
                let meant = look_alike(character).filter(|_| more == 0);
                sink.report(&RULE, range.clone(), message).count(1 + more).fixes(meant.map(|meant| {
                    let title = if meant == " " { "Write a blank".to_owned() } else { format!("Write {meant}") };
                    Fix::replace(title, range, meant)
                }));
            }
            StrayKind::Disregarded(character) => {
                let joined =
                    |pair: &[Stray]| pair[0].to == pair[1].from && matches!(pair[1].kind, StrayKind::Disregarded(_));
                let more = strays[at - 1..].windows(2).take_while(|pair| joined(pair)).count();
                at += more;
                let name = control.code.row(character).and_then(|row| control.code.meaning(row)).map_or("", |it| it.1);
                let message = format!("{} is punched as {name}; a control disregards it.", named(character));
                let range = stray.range().start..strays[at - 1].range().end;
                sink.report_as(Severity::Info, &RULE, range, message).count(1 + more);
            }
            StrayKind::Label => {
                let message = "A control passes over everything up to the program start, or to the first end of block: \
                               this is a label for people.";
                sink.report_as(Severity::Info, &RULE, stray.range(), message.to_owned());
            }
            StrayKind::LabelBehindStart => {
                let message = "Between the program start % and the end of block behind it only a program number may \
                               stand. Put the text into a comment, or before the %.";
                let (from, to) = (stray.range().start, stray.range().end);
                sink.report(&RULE, from..to, message.to_owned()).fix(|| {
                    Fix::edits("Put it into a comment", [(from..from, "(".to_owned()), (to..to, ")".to_owned())])
                });
            }
            StrayKind::InComment(character) => {
                let message =
                    format!("{} has no row in {code}: it is left out of the comment on the tape.", named(character));
                sink.report_as(Severity::Info, &RULE, stray.range(), message);
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
