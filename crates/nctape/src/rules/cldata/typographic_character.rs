//! CLD-02: a typographic character stands for one of ISO/IEC 646.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "typographic-character",
    title: "A typographic character stands for one of ISO/IEC 646.",
    verdicts: Verdicts::cldata("CLD-02", Severity::Error),
    clauses: &[Clause::Iso3592("4"), Clause::Iso3592("5.4")],
    page: page!("CLD-02"),
};

pub(crate) fn check(view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let mut found = view.tables.typographic.clone();
    order_by_key(&mut found, |typographic| (typographic.range.start, 0));
    let Some(first) = found.first() else { return };
    let message = format!(
        "{} is a typographic character; ISO/IEC 646 has none, and the record needs {}. Editors and printed pages put \
         such \
         characters in: replace them all.",
        quoted(view.at(&first.range)),
        if first.plain == ' ' { "a space, or nothing".to_owned() } else { quoted(&first.plain.to_string()) }
    );
    sink.report(&RULE, first.range.clone(), message).count(found.len()).fix(|| {
        let edits = found.iter().map(|typographic| (typographic.range.clone(), typographic.plain.to_string()));
        Fix::edits("Replace them all", edits)
    });
}
