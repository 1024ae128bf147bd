//! FEED-06: the second digit of an arithmetic code is zero.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "second-digit-zero",
    title: "The second digit of an arithmetic code is zero.",
    verdicts: Verdicts::all("FEED-06", Severity::Error),
    clauses: &[Clause::Iso2539("A.2.2"), Clause::Iso1058("A.1.1")],
    page: page!("FEED-06"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::SecondDigitZero { word } = event.kind else { return };
    let Some((range, word)) = tape.word(event.block, word) else { return };
    let message = format!(
        "{} is an arithmetic code whose second digit is zero; that digit is the first one of the speed that is not \
         zero, unless all digits are zero. Write the code of the speed that is meant.",
        &tape.text[range.clone()],
    );
    let reported = sink.report(&RULE, range.clone(), message);
    if let Some(code) = word.value.and_then(|code| same_value(code, word.digits)) {
        let written = &tape.text[range.clone()];
        let head = &written[..written.find(|c: char| c.is_ascii_digit()).unwrap_or(0)];
        let instead = format!("{head}{code:0>width$}", width = usize::from(word.digits));
        reported.fix(|| Fix::replace(format!("Write {instead} (the same value)"), range, instead));
    }
}

/// The code of the value that a code with leading zeros behind its first digit says; `None` where there is none.
fn same_value(code: i64, digits: u16) -> Option<i64> {
    let scale = crate::format::power_of_ten(u8::try_from(digits.checked_sub(1)?).ok()?);
    let (mut first, mut others) = (code / scale, code % scale);
    if others == 0 {
        return Some(0);
    }
    while others < scale / 10 {
        first -= 1;
        others *= 10;
    }
    (first >= 0).then_some(first * scale + others)
}

#[cfg(test)]
mod tests {
    use super::same_value;

    #[test]
    fn the_digits_move_to_the_left() {
        // By hand: 605 is 0,05 x 10^3 = 50, which is 550.
        assert_eq!(same_value(605, 3), Some(550));
        assert_eq!(same_value(6005, 4), Some(4500));
        assert_eq!(same_value(600, 3), Some(0));
        assert_eq!(same_value(5, 3), None);
    }
}
