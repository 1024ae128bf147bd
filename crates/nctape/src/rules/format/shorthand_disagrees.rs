//! SPEC-22: the EIA shorthand and the detail disagree.
//!
//! Figure 4 of Y-1702, which explains the shorthand, is lost, so what its digits mean is a guess. Most likely are the
//! motions, the channels and the axes, whose order a handbook gives; less likely the other words and the type of the
//! dimensions: those are notes.

use crate::format::{Detail, Dimensions, Shorthand, Sign};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "shorthand-disagrees",
    title: "The EIA shorthand and the detail disagree.",
    verdicts: Verdicts::eia("SPEC-22", Severity::Warning),
    clauses: &[Clause::Y1702("figure 4")],
    page: page!("SPEC-22"),
};

/// A shorthand that says nothing, or contradicts itself.
pub(crate) fn check_alone(text: &str, sink: &mut Sink<'_>) {
    let message = match Shorthand::read(text) {
        None => format!(
            "{} is no shorthand of RS-274 that can be read: a letter and two, three and two digits, as in c23.314.22. It \
             decides nothing; correct it, or leave the field out.",
            if text.trim().is_empty() { "An empty text" } else { text }
        ),
        Some(read) if read.channels > read.axes => format!(
            "The shorthand {text} probably says {} motions at a time, but {} axes; none is more than the other. Correct \
             one of them.",
            read.channels, read.axes
        ),
        Some(_) => return,
    };
    sink.report(&RULE, 0..text.len(), message);
}

/// What the shorthand probably says and the detail does not. It is said once for both, with all that differs.
pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    let Some(shorthand) = &control.format.classification else { return };
    let Some(read) = Shorthand::read(shorthand) else { return };
    if super::is_uncountable(detail, control) {
        return;
    }
    let motions: Vec<_> =
        detail.words.iter().filter(|word| word.dimension && control.axis(word.address as u8).is_some()).collect();
    let others = detail.words.iter().filter(|word| !word.dimension && word.address != 'N').count();
    let places = motions.iter().find(|word| (word.before, word.after) != (read.before, read.after));
    let (mut differ, mut unsure) = (Vec::new(), Vec::new());
    let counted = |count: u8, found: usize, what: &str| format!("{count} {what}, but the detail has {found}");
    if usize::from(read.motions) != motions.len() {
        differ.push(counted(read.motions, motions.len(), "words of motions"));
    }
    if let Some(word) = places {
        differ.push(format!(
            "{} before and {} behind the decimal sign, but {} has {} and {}",
            digits(u16::from(read.before)),
            read.after,
            word.text(),
            word.before,
            word.after
        ));
    }
    // The axes are the motions as a rule: one word too few or too many is one fault.
    if usize::from(read.axes) != motions.len() && (read.axes != read.motions) {
        differ.push(counted(read.axes, motions.len(), "axes"));
    }
    if usize::from(read.others) != others {
        unsure.push(counted(read.others, others, "other words"));
    }
    let signed = motions.iter().find(|word| read.kind == 1 && word.sign != Sign::Positive);
    if let Some(word) = signed {
        unsure.push(format!("dimensions without sign, but the detail has {}", word.text()));
    }
    match (read.kind, control.format.itemized.dimensions) {
        (1 | 2, Some(Dimensions::Incremental)) => {
            unsure.push("absolute dimensions, but the itemized data incremental ones".to_owned());
        }
        (3, Some(Dimensions::Absolute)) => {
            unsure.push("incremental dimensions, but the itemized data absolute ones".to_owned());
        }
        _ => {}
    }
    let severity = if differ.is_empty() { Severity::Info } else { Severity::Warning };
    // One word alone is marked where nothing but its digits differ.
    let range = match (places, &differ[..], signed) {
        (Some(word), [_], _) if unsure.is_empty() => word.range.clone(),
        (None, [], Some(word)) if unsure.len() == 1 => word.range.clone(),
        _ => 0..detail.length,
    };
    differ.append(&mut unsure);
    if !differ.is_empty() {
        let message = format!(
            "The shorthand {} probably says {}. The detail and the itemized data hold; correct one of them.",
            shorthand.trim(),
            differ.join("; ")
        );
        sink.report_as(severity, &RULE, range, message).count(differ.len());
    }
}

#[cfg(test)]
mod tests {
    use crate::format::{Dimensions, Format, Standard, explain};

    fn found(shorthand: &str, dimensions: Option<Dimensions>) -> Vec<(&'static str, String)> {
        let mut format = Format::new(Standard::Rs274, "n3 g2 x+14 y+14 f21 m2*").classified(shorthand);
        format.itemized.dimensions = dimensions;
        let found = explain(&format).diagnostics;
        found
            .iter()
            .map(|it| (it.diagnostic.severity.name(), it.text[it.diagnostic.range.clone()].to_owned()))
            .collect()
    }

    #[test]
    fn what_the_shorthand_is_less_sure_of_is_a_note() {
        assert_eq!(found("c24.314.22", None), [("info", "n3 g2 x+14 y+14 f21 m2*".to_owned())]);
        assert_eq!(found("c23.114.22", None), [("info", "x+14".to_owned())]);
        assert_eq!(found("c23.314.22", Some(Dimensions::Absolute)).len(), 1);
        assert_eq!(found("c23.214.22", Some(Dimensions::Incremental)).len(), 1);
    }

    #[test]
    fn what_agrees_is_not_said() {
        assert_eq!(found("c23.314.22", None), []);
        assert_eq!(found("C23.314.22", Some(Dimensions::Incremental)), []);
        assert_eq!(found("c23.214.22", Some(Dimensions::Absolute)), []);
    }

    #[test]
    fn words_of_motions_and_axes_are_one_disagreement() {
        assert_eq!(found("c33.314.23", None), [("warning", "n3 g2 x+14 y+14 f21 m2*".to_owned())]);
        assert_eq!(found("c34.113.22", None).len(), 1);
    }
}
