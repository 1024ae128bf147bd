//! MOT-05: I, J and K fit only by another reading.

use crate::diagnostic::Edit;
use crate::execute::{ArcFault, Event, EventKind};
use crate::format::ArcCentre;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "centre-by-another-reading",
    title: "I, J and K fit only by another reading.",
    verdicts: Verdicts::contouring("MOT-05", Severity::Error),
    clauses: &[Clause::Iso2539("figure 2"), Clause::Iso2539("annex E")],
    page: page!("MOT-05"),
};

pub(crate) fn check(event: &Event, tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let EventKind::Arc(ArcFault::RadiusMismatch { start, end, read, fits: Some(fits), .. }) = event.kind else {
        return;
    };
    let places = tape.places();
    let stated = tape.control.arc_centre;
    let message = format!(
        "Read as {}, I, J and K put the end off the circle (radius {start:.places$} at the start, {end:.places$} at the \
         end); read as {} they fit. Annex E of ISO 2539 writes start minus centre, its figure 2 centre minus start: \
         state which one the control wants.",
        stated.title(),
        fits.title()
    );
    // Only these two differ by their signs.
    let opposite =
        matches!((read, fits), (ArcCentre::FromStart, ArcCentre::ToStart) | (ArcCentre::ToStart, ArcCentre::FromStart));
    let signs = reversed(event.block, tape).filter(|_| opposite);
    let mut format = tape.control.format.clone();
    format.itemized.arc_centre = Some(fits);
    let title = format!("Read I, J and K as {} (arcCentre: {})", fits.title(), fits.word());
    let reported = sink.report(&RULE, tape.parameters(event.block), message);
    let reported = match signs {
        Some(edits) => reported.fix(|| Fix {
            title: "Reverse the signs of I, J and K in this block".to_owned(),
            edits,
            format: None,
            language: None,
        }),
        None => reported,
    };
    reported.fix(|| Fix::reformat(title, format));
}

/// Edits that reverse the sign of each interpolation parameter of a block; `None` where one has none to reverse
/// and the format has no sign.
fn reversed(index: usize, tape: &TapeView<'_>) -> Option<Vec<Edit>> {
    let block = &tape.reading.blocks[index];
    let parameters = tape.reading.words(block).iter().filter(|word| matches!(word.address, b'I' | b'J' | b'K'));
    let edit = |word: &Word| {
        let range = tape.reading.range(block, word);
        let text = &tape.text[range.clone()];
        let at = text.find(['+', '-']).map(|at| range.start + at);
        Some(match (at, word.sign) {
            (Some(at), Some(b'-')) => Edit { range: at..at + 1, insert: "+".to_owned() },
            (Some(at), _) => Edit { range: at..at + 1, insert: "-".to_owned() },
            (None, _) => Edit { range: range.start + 1..range.start + 1, insert: "-".to_owned() },
        })
    };
    parameters.map(edit).collect()
}
