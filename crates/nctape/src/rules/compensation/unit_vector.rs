//! COMP-01: P, Q and R are no unit vector.

use crate::format::power_of_ten;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "compensation-vector-length",
    title: "P, Q and R are no unit vector.",
    verdicts: Verdicts::contouring("COMP-01", Severity::Error),
    clauses: &[Clause::Iso2539("5")],
    page: page!("COMP-01"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    if block.control.format.itemized.compensation != Some(true) {
        return;
    }
    let mut components = block.words.iter().filter(|word| matches!(word.address, b'P' | b'Q' | b'R')).peekable();
    let Some(first) = components.peek().map(|word| word.range()) else { return };
    let (mut square, mut increment, mut last) = (0.0, 0.0_f64, first.end);
    for word in components {
        let (Some(value), Some(designation)) = (word.value, block.control.designation(word.address)) else { return };
        let scale = power_of_ten(designation.after) as f64;
        square += (value as f64 / scale) * (value as f64 / scale);
        increment = increment.max(1.0 / scale);
        last = word.range().end;
    }
    let length = square.sqrt();
    // Each of three components may be off by one increment: together by √3 of them.
    if (length - 1.0).abs() > 3.0_f64.sqrt() * increment {
        let message = format!(
            "P, Q and R are the unit vector of cutter compensation; their length is {length:.3}, not 1. Correct them."
        );
        sink.report(&RULE, first.start..last, message);
    }
}
