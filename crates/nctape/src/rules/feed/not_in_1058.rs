//! FEED-16: ISO 1058 has no such coding of feeds and speeds.

use crate::format::{Detail, FeedCoding, FormatDiagnostic, SpindleCoding};
use crate::rules::format::report_field;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "coding-not-in-positioning-format",
    title: "ISO 1058 has no such coding of feeds and speeds.",
    verdicts: Verdicts::positioning("FEED-16", Severity::Error),
    clauses: &[Clause::Iso1058("annex A")],
    page: page!("FEED-16"),
};

pub(crate) fn check(control: &Control, problems: &mut Vec<FormatDiagnostic>) {
    let stated = &control.format.itemized;
    let mut report = |path: &str, coding: &str| {
        let message = format!(
            "{coding} is a coding of ISO 2539; ISO 1058 has the arithmetic (3 to 5 digits), the geometric (2) and the \
             symbolic one (1). State one of them."
        );
        report_field(&RULE, control.standard(), (path, coding), &message, problems);
    };
    if let Some(coding @ (FeedCoding::TimeReciprocal | FeedCoding::Direct)) = stated.feed {
        report("itemized.feed", coding.word());
    }
    if let Some(coding @ SpindleCoding::Direct) = stated.spindle {
        report("itemized.spindle", coding.word());
    }
}

/// Where no coding is stated the digits tell it, and there is none of six or more.
pub(crate) fn check_detail(detail: &Detail, control: &Control, sink: &mut Sink<'_>) {
    let stated = &control.format.itemized;
    for word in &detail.words {
        let open = word.address == 'F' && stated.feed.is_none() || word.address == 'S' && stated.spindle.is_none();
        if open && word.digits.len() == 1 && word.before > 5 {
            let message = format!(
                "{} has {}; ISO 1058 has the arithmetic coding (3 to 5 digits), the geometric (2) and the symbolic one \
                 (1). Write the digits of one of them.",
                word.text(),
                digits(word.width().into())
            );
            sink.report(&RULE, word.range.clone(), message);
        }
    }
}

/// G93 asks for the reciprocal of time on the tape itself.
pub(crate) fn check_word(word: &Word, sink: &mut Sink<'_>) {
    if word.function(b'G') == Some(93) && word.digits == 2 {
        let message = "G93 makes the feed the reciprocal of time, a coding of ISO 2539; ISO 1058 has the arithmetic, the \
                       geometric and the symbolic one. Take it out.";
        sink.report(&RULE, word.range(), message.to_owned());
    }
}
