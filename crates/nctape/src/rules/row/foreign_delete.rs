//! ROW-08: an EIA tape has the delete of ISO code.

use crate::code::Code;
use crate::rules::prelude::{Clause, Rule, Severity, Verdicts, page};

/// The rule.
pub static RULE: Rule = Rule {
    name: "delete-of-the-other-code",
    title: "An EIA tape has the delete of ISO code.",
    verdicts: Verdicts::all("ROW-08", Severity::Warning),
    clauses: &[Clause::Both("1.5")],
    page: page!("ROW-08"),
};

/// What is said of a row.
pub(crate) fn message(_: u8, code: Code) -> String {
    format!(
        "The row has all eight holes, the delete of ISO 840; that of {} has tracks 1 to 7, because track 8 is the end of \
         block. It is left out of the listing, but a control may stop here: leave such a row out of the next copy.",
        code.name()
    )
}
