//! CLD-04: the character is not of ISO/IEC 646.

use super::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "character-beyond-iso-646",
    title: "The character is not of ISO/IEC 646.",
    verdicts: Verdicts::cldata("CLD-04", Severity::Error),
    clauses: &[Clause::Iso3592("4"), Clause::Iso3592("5.5")],
    page: page!("CLD-04"),
};

pub(crate) fn check(found: &Slipped, view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let Slip::Beyond { count, literal } = found.slip else { return };
    let what = quoted(view.at(&found.range));
    let (severity, advice) = match literal {
        true => {
            (Severity::Warning, "The literal may not reach the machine as it is written here: write it with A to Z.")
        }
        false => (Severity::Error, "The element cannot be read. Take it out."),
    };
    let has = if count == 1 { "a character" } else { "characters" };
    sink.report_as(severity, &RULE, found.range.clone(), format!("{what} has {has} beyond ISO/IEC 646. {advice}"))
        .count(count);
}
