//! SPEC-12: the words of the detail stand out of order.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "detail-out-of-order",
    title: "The words of the detail stand out of order.",
    verdicts: Verdicts::all("SPEC-12", Severity::Error),
    clauses: &[Clause::Both("D.3"), Clause::Both("3.2.2")],
    page: page!("SPEC-12"),
};

/// The order of the words of a block: 3.2.1 and 3.2.2.
const ORDER: &str = "NGXYZUVWPQRIJKABCDEFSTM";

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    let mut highest = 0;
    for (index, word) in detail.words.iter().enumerate() {
        let stands_twice = detail.words[..index].iter().any(|before| before.address == word.address);
        if stands_twice && !may_repeat(word.address, control.standard()) {
            let message =
                format!("{}: {} stands in the detail already. Take one of them out.", word.text(), word.address);
            sink.report(&RULE, word.range.clone(), message);
            return;
        }
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

/// A block may hold several words of the letter: tool functions in ISO 2539 (3.2.2.5), miscellaneous functions in
/// ISO 1058 (3.2.2.6). The second and the third feed have letters of their own, E and D.
fn may_repeat(address: char, standard: Standard) -> bool {
    match standard {
        Standard::Iso1058 => address == 'M',
        Standard::Iso2539 | Standard::Rs274 => address == 'T',
    }
}
