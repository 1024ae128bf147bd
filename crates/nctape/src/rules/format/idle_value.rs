//! SPEC-27: a value of the itemized data decides nothing.

use crate::format::{Designation, FeedCoding, FormatDiagnostic, SetPoint};
use crate::function::{Preparatory, preparatory};
use crate::rules::prelude::*;
use std::collections::BTreeMap;

/// The rule.
pub static RULE: Rule = Rule {
    name: "idle-format-value",
    title: "A value of the itemized data decides nothing.",
    verdicts: Verdicts::all("SPEC-27", Severity::Warning),
    clauses: &[],
    page: page!("SPEC-27"),
};

pub(crate) fn check(control: &Control, problems: &mut Vec<FormatDiagnostic>) {
    let stated = &control.format.itemized;
    let mut report = |field: &str, message: Option<String>| {
        if let Some(message) = message {
            let path = format!("itemized.{field}");
            super::report_field(&RULE, control.standard(), (&path, ""), &message, problems);
        }
    };
    report("setPoint", stated.set_point.as_ref().and_then(|point| set_point(point, control)));
    report("travel", stated.travel.as_ref().and_then(|travel| no_axes(travel.keys(), control)));
    report("curves", stated.curves.as_ref().and_then(|curves| curve_codes(curves.keys())));
    let feed = (control.feed == FeedCoding::Symbolic, control.feed.word(), 'F');
    report("symbolicFeeds", stated.symbolic_feeds.as_ref().and_then(|table| symbols(table, feed, control)));
    let speed = (control.spindle == FeedCoding::Symbolic, control.spindle.word(), 'S');
    report("symbolicSpeeds", stated.symbolic_speeds.as_ref().and_then(|table| symbols(table, speed, control)));
    if let Some(declared) = &stated.declared {
        report("declared", functions('G', declared.g.keys()));
        report("declared", functions('M', declared.m.keys()));
        report("declared", letters(declared.letters.keys()));
    }
    report("compensationDigits", stated.compensation_digits.and_then(|digits| compensation_digits(digits, control)));
    let dwell = stated.dwell.as_ref().filter(|dwell| control.designation(dwell.address as u8).is_none());
    report(
        "dwell",
        dwell.map(|dwell| {
            format!("The detail has no word {}, so no word carries a dwell. Name one that it has.", dwell.address)
        }),
    );
}

fn set_point(point: &SetPoint, control: &Control) -> Option<String> {
    match point {
        SetPoint::Named(numbers) => no_axes(numbers.keys(), control),
        SetPoint::InOrder(numbers) => (numbers.len() > control.axes.len()).then(|| {
            format!(
                "There are {} numbers for {} axes ({}); what stands behind them decides nothing. Take it out.",
                numbers.len(),
                control.axes.len(),
                axes(control)
            )
        }),
    }
}

fn axes(control: &Control) -> String {
    control.axes.iter().map(|axis| axis.letter.to_string()).collect::<Vec<_>>().join(" ")
}

/// The names that fail a test, in one text; `None` where there is none.
fn failing<'a>(names: impl Iterator<Item = &'a String>, fits: impl Fn(&str) -> bool) -> Option<String> {
    let failing: Vec<String> = names.filter(|name| !fits(name)).map(|name| format!("\"{name}\"")).collect();
    (!failing.is_empty()).then(|| failing.join(", "))
}

fn no_axes<'a>(names: impl Iterator<Item = &'a String>, control: &Control) -> Option<String> {
    let is_axis = |name: &str| control.axes.iter().any(|axis| name == axis.letter.encode_utf8(&mut [0; 4]));
    failing(names, is_axis)
        .map(|names| format!("{names}: the axes of this format are {}; anything else decides nothing.", axes(control)))
}

/// The number of a code such as G05: its letter and two digits.
fn code(name: &str, letter: char) -> Option<u8> {
    let digits = name.strip_prefix(letter)?;
    let two = digits.len() == 2 && digits.bytes().all(|digit| digit.is_ascii_digit());
    digits.parse().ok().filter(|_| two)
}

fn curve_codes<'a>(names: impl Iterator<Item = &'a String>) -> Option<String> {
    let free = |name: &str| code(name, 'G').is_some_and(|code| !matches!(preparatory(code), Preparatory::Assigned(..)));
    failing(names, free).map(|names| {
        format!(
            "{names}: a curve has a code of G and two digits to which ISO 1056 gives no meaning, such as \"G05\"; \
             anything else decides nothing."
        )
    })
}

fn symbols(table: &BTreeMap<String, f64>, coding: (bool, &str, char), control: &Control) -> Option<String> {
    let (symbolic, coding, letter) = coding;
    if !symbolic {
        return Some(format!(
            "The coding of {letter} is {coding}, which needs no table. State \"symbolic\", or take the table out."
        ));
    }
    let width = control.designation(letter as u8).map_or(u8::MAX, Designation::width);
    let fits = |name: &str| {
        let code = name.trim().trim_start_matches('0');
        code.len() <= usize::from(width) && !name.trim().is_empty() && code.bytes().all(|digit| digit.is_ascii_digit())
    };
    failing(table.keys(), fits)
        .map(|names| format!("{names}: no word {letter} of this format can say it. A code has digits, such as \"7\"."))
}

fn functions<'a>(letter: char, names: impl Iterator<Item = &'a String>) -> Option<String> {
    failing(names, |name| code(name, letter).is_some()).map(|names| {
        format!("{names}: a function is written {letter} and two digits, such as \"{letter}52\"; anything else decides nothing.")
    })
}

fn letters<'a>(names: impl Iterator<Item = &'a String>) -> Option<String> {
    let fits = |name: &str| matches!(name.as_bytes(), [b'A'..=b'N' | b'P'..=b'Z']);
    failing(names, fits)
        .map(|names| format!("{names}: an address is one capital letter, and not O; anything else decides nothing."))
}

fn compensation_digits(stated: u8, control: &Control) -> Option<String> {
    let width = control.designation(b'T').map_or(0, Designation::width);
    let tool = match width {
        0 => "The detail has no word T".to_owned(),
        _ => format!("T has {}", digits(u16::from(width))),
    };
    (stated > width).then(|| format!("{tool}, so its last {stated} select nothing. State as many as T has at most."))
}
