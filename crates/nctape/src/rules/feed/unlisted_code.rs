//! FEED-12: a symbolic code has no value.

use crate::execute::EventKind;
use crate::rules::prelude::*;
use std::collections::{BTreeMap, HashMap};

/// The rule.
pub static RULE: Rule = Rule {
    name: "code-without-value",
    title: "A symbolic code has no value.",
    verdicts: Verdicts::all("FEED-12", Severity::Error),
    clauses: &[Clause::Iso2539("A.4"), Clause::Iso1058("A.3")],
    page: page!("FEED-12"),
};

/// Said once for each code, with how many words it holds for; once for all of an address whose table is not stated.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let stated = &tape.control.format.itemized;
    let mut said: Vec<(u8, std::ops::Range<usize>, usize)> = Vec::new();
    let mut places: HashMap<(u8, Option<i64>), usize> = HashMap::new();
    for event in &tape.execution.events {
        let EventKind::Unlisted { word } = event.kind else { continue };
        let Some((range, word)) = tape.word(event.block, word) else { continue };
        let table = if word.address == b'F' { &stated.symbolic_feeds } else { &stated.symbolic_speeds };
        let code = word.value.filter(|_| table.is_some());
        let place = *places.entry((word.address, code)).or_insert(said.len());
        match said.get_mut(place) {
            Some(other) => other.2 += 1,
            None => said.push((word.address, range, 1)),
        }
    }
    for (address, range, count) in said {
        let (field, table, what) = match address {
            b'F' => ("symbolicFeeds", &stated.symbolic_feeds, "feed"),
            _ => ("symbolicSpeeds", &stated.symbolic_speeds, "spindle speed"),
        };
        let written = &tape.text[range.clone()];
        let known = match table {
            Some(table) if !table.is_empty() => format!("{field} has {}", listed(table)),
            _ => format!("{field} is not stated"),
        };
        let message = format!(
            "{written} is a symbolic {what} code, and the itemized data gives it no value: {known}. State its value, \
             or write a code that has one."
        );
        sink.report(&RULE, range, message).count(count);
    }
}

/// The codes of a table, the first dozen of them.
fn listed(table: &BTreeMap<String, f64>) -> String {
    let codes: Vec<&str> = table.keys().take(12).map(String::as_str).collect();
    format!("{}{}", codes.join(", "), if table.len() > codes.len() { " …" } else { "" })
}
