//! SPEC-22: the EIA shorthand and the detail disagree.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "shorthand-disagrees",
    title: "The EIA shorthand and the detail disagree.",
    verdicts: Verdicts::eia("SPEC-22", Severity::Warning),
    clauses: &[Clause::Y1702("figure 4")],
    page: page!("SPEC-22"),
};

/// Figure 4, which explains the shorthand, is lost, so what its digits mean is a guess: see `explain`.
pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    let Some(shorthand) = &control.format.classification else { return };
    let figures: Vec<u8> = shorthand.bytes().filter(u8::is_ascii_digit).map(|digit| digit - b'0').collect();
    let [_, _, _, before, after, _, axes] = figures[..] else { return };
    let motions = control.axes.iter().filter(|axis| axis.sign.is_some()).count();
    let other = detail.words.iter().find(|word| {
        let motion = control.axis(word.address as u8).is_some() && word.dimension;
        motion && (word.before, word.after) != (before, after)
    });
    let (range, what) = if let Some(word) = other {
        let says = format!(
            "{} before and {after} behind the decimal sign, but {} has {} and {}",
            digits(u16::from(before)),
            word.text(),
            word.before,
            word.after
        );
        (word.range.clone(), says)
    } else if motions != usize::from(axes) {
        (0..detail.length, format!("{axes} axes, but the detail has {motions}"))
    } else {
        return;
    };
    let message = format!("The shorthand {shorthand} probably says {what}. The detail holds; correct one of them.");
    sink.report(&RULE, range, message);
}
