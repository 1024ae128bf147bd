//! CLD-17: the numbers of the records do not run from 1 by 1.

use super::prelude::*;
use std::ops::Range;

/// The rule.
pub static RULE: Rule = Rule {
    name: "broken-record-sequence",
    title: "The numbers of the records do not run from 1 by 1.",
    verdicts: Verdicts::cldata("CLD-17", Severity::Error),
    clauses: &[Clause::Iso3592("4")],
    page: page!("CLD-17"),
};

pub(crate) fn check(view: &CldataView<'_>, sink: &mut Sink<'_>) {
    let mut is_first = true;
    for records in view.tables.file_records() {
        let mut wanted = 1;
        for record in &view.tables.records[records.clone()] {
            let number = view.number(record);
            if let Some((found, range)) = number.filter(|(found, _)| *found != wanted) {
                let message = format!(
                    "The record has the number {found}; {}. The numbers of a file begin with 1 and rise by 1.",
                    if wanted == 1 {
                        "the first of a file is 1".to_owned()
                    } else {
                        format!("behind {} comes {wanted}", wanted - 1)
                    }
                );
                let whole = std::mem::take(&mut is_first).then(|| renumber(records.clone(), view));
                sink.report(&RULE, range, message).fixes(whole);
                wanted = found;
            }
            wanted = wanted.saturating_add(1);
        }
    }
}

fn renumber(records: Range<usize>, view: &CldataView<'_>) -> Fix {
    let numbered = view.tables.records[records].iter().zip(1_i64..);
    let edits = numbered.filter_map(|(record, number)| {
        let (found, range) = view.number(record)?;
        (found != number).then(|| (range, number.to_string()))
    });
    Fix::edits("Number the records of the file anew", edits)
}
