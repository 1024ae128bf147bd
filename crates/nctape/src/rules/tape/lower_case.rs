//! TAPE-09: address characters are capital letters.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "lower-case-address",
    title: "Address characters are capital letters.",
    verdicts: Verdicts::all("TAPE-09", Severity::Warning).not_rs274(),
    clauses: &[Clause::Both("annex B")],
    page: page!("TAPE-09"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    if !tape.seen.any(Traits::LOWER_CASE) {
        return;
    }
    // A letter without digits is no address: WORD-10, or a text.
    let mut found = tape.words().filter(|(_, word)| word.lower_case && word.fault != NumberFault::Empty);
    let Some((block, word)) = found.next() else { return };
    let (mut count, mut last) = (1, (block, word));
    for other in found {
        (count, last) = (count + 1, other);
    }
    let code = match tape.control.code {
        Code::Iso => "ISO code has capital letters only",
        Code::Eia => "addresses are capital letters, and EIA code has one case only",
    };
    let message = format!(
        "The address {} is written in lower case; {code}, and it is punched as {}.",
        char::from(word.address).to_ascii_lowercase(),
        word.letter()
    );
    let range = tape.range(block, word);
    let all = range.start..tape.range(last.0, last.1).end;
    sink.report(&RULE, range, message)
        .count(count)
        .fix(|| Fix::replace("Write capitals", all.clone(), tape.text[all].to_ascii_uppercase()));
}
