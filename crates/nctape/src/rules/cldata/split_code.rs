//! CLD-45: systems have different words for the integer code.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "code-with-two-words",
    title: "Systems have different words for the integer code.",
    verdicts: Verdicts::cldata("CLD-45", Severity::Info),
    clauses: &[Clause::Iso3592("6.3")],
    page: page!("CLD-45"),
};

pub(crate) fn check(view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let is = |found: &&Noted| matches!(found.event, Event::SplitCode { .. });
    let count = view.execution.events.iter().filter(is).count();
    let Some(first) = view.execution.events.iter().find(is) else { return };
    let Event::SplitCode { word, other } = first.event else { return };
    let range = view.event(first);
    let message = format!(
        "{} is {} in most systems and {} in another. The dialect, where it is stated, decides.",
        view.at(&range),
        word.word(),
        other.word()
    );
    sink.report(&RULE, range, message).count(count);
}
