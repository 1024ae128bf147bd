//! SPEC-12: the words of the detail stand out of order.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "detail-out-of-order",
    title: "The words of the detail stand out of order.",
    verdicts: Verdicts::all("SPEC-12", Severity::Error).not_rs274(),
    clauses: &[Clause::Both("D.3"), Clause::Both("3.2.2")],
    page: page!("SPEC-12"),
};

/// The order of the words of a block: 3.2.1 and 3.2.2.
const ORDER: &str = "NGXYZUVWPQRIJKABCDEFSTM";

pub(crate) fn check(detail: &Detail, _: &Control, sink: &mut Sink<'_>) {
    let mut highest = 0;
    for word in &detail.words {
        // D and E may be feed or tool functions, with a place of their own.
        let place = ORDER.find(word.address).filter(|_| word.dimension || !"DE".contains(word.address));
        match place {
            Some(place) if place < highest => {
                let message = format!(
                    "{} stands too late; the words run N G X Y Z U V W P Q R I J K A B C D E F S T M.",
                    word.text()
                );
                sink.report(&RULE, word.range.clone(), message);
                return;
            }
            Some(place) => highest = place,
            None => {}
        }
    }
}
