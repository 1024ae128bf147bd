//! NUM-20: an angle is beyond one turn.

use crate::format::{Angles, Sign, power_of_ten};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "angle-beyond-a-turn",
    title: "An angle is beyond one turn.",
    verdicts: Verdicts::all("NUM-20", Severity::Warning).not_rs274(),
    clauses: &[Clause::Both("3.3.3.2.2")],
    page: page!("NUM-20"),
};

pub(crate) fn check(word: &Word, block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if !matches!(word.address, b'A' | b'B' | b'C') {
        return;
    }
    let Some(designation) = block.control.designation(word.address).filter(|word| word.dimension) else { return };
    // Incremental dimensions may well be several turns.
    if !matches!(designation.sign, Sign::Positive | Sign::Signed) {
        return;
    }
    let Some(angles) = block.control.classification.as_ref().and_then(|found| found.angles()) else { return };
    let (turn, unit) = match angles {
        Angles::Turns => (1, "turns"),
        Angles::Degrees => (360, "degrees"),
    };
    let scale = power_of_ten(designation.after);
    if let Some(value) = word.value.filter(|value| value.unsigned_abs() > (turn * scale) as u64) {
        let message = format!(
            "{} is {:.places$} {unit}, more than one turn; an absolute angle lies within one. Write the angle that is \
             left.",
            word.letter(),
            value as f64 / scale as f64,
            places = usize::from(designation.after)
        );
        sink.report(&RULE, word.range(), message);
    }
}
