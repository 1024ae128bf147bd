//! SPEC-09: the dimension words are not as many as the classification says.

use crate::format::Detail;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "motion-count-differs",
    title: "The dimension words are not as many as the classification says.",
    verdicts: Verdicts::all("SPEC-09", Severity::Warning).not_rs274(),
    clauses: &[Clause::Both("C.2.2")],
    page: page!("SPEC-09"),
};

pub(crate) fn check(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    if super::is_uncountable(detail, control) {
        return;
    }
    let Some([_, stated, _]) = control.classification.as_ref().and_then(|found| found.digits()) else { return };
    let axes = control.axes.iter().filter(|axis| axis.sign.is_some());
    let (mut least, mut most) = (0, 0);
    for axis in axes {
        match motion(axis.letter, control) {
            Some(false) => {}
            Some(true) => (least, most) = (least + 1, most + 1),
            None => most += 1,
        }
    }
    if !(least..=most).contains(&usize::from(stated)) {
        let found = if least == most { least.to_string() } else { format!("{least} to {most}") };
        let message = format!(
            "The detail has {found} dimension words for motions; the second digit of the classification says {stated}. \
             Correct one of them."
        );
        sink.report(&RULE, 0..detail.length, message);
    }
}

/// Whether a dimension letter stands for a motion; `None` where that is open: the meaning is not declared, which
/// WORD-16 says, or it is declared in words that annex B does not use.
fn motion(letter: char, control: &Control) -> Option<bool> {
    let Some(meaning) = declared_letter(letter, control) else {
        let stated = "PQR".contains(letter) && control.format.itemized.compensation.is_some();
        return if !"DEPQRUVW".contains(letter) || stated { Some(true) } else { None };
    };
    let says = |words: &[&str]| words.iter().any(|word| meaning.to_lowercase().contains(word));
    match () {
        // A correction of an axis is named before the axis: cutter compensation for X.
        () if says(&["compensation", "feed", "tool"]) => Some(false),
        () if says(&["motion", "dimension"]) => Some(true),
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::format::{Format, Standard, explain};

    /// The rules that are found in X, Y, Z and P under a classification, with a meaning of P or none.
    fn found(classification: &str, meaning: Option<&str>) -> Vec<&'static str> {
        let mut format = Format::new(Standard::Iso2539, "N3G2X+42Y+42Z+42P+24F4*").classified(classification);
        if let Some(meaning) = meaning {
            let letters = &mut format.itemized.declared.get_or_insert_default().letters;
            letters.insert("P".to_owned(), meaning.to_owned());
        }
        explain(&format).diagnostics.iter().map(|found| found.diagnostic.id).collect()
    }

    #[test]
    fn an_undeclared_letter_is_said_once_whatever_the_count() {
        assert_eq!(found("CAM 333", None), ["WORD-16"]);
        assert_eq!(found("CAM 443", None), ["WORD-16"]);
        assert_eq!(found("CAM 222", None), ["SPEC-09", "WORD-16"]);
    }

    #[test]
    fn a_meaning_that_is_not_understood_may_be_a_motion_or_not() {
        assert_eq!(found("CAM 333", Some("quill")), [""; 0]);
        assert_eq!(found("CAM 443", Some("quill")), [""; 0]);
        assert_eq!(found("CAM 553", Some("quill")), ["SPEC-09"]);
    }
}
