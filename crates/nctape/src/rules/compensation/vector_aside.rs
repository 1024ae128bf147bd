//! COMP-03: the vector of cutter compensation lies otherwise than declared.

use crate::execute::EventKind;
use crate::format::CompensationVector;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "compensation-vector-aside",
    title: "The vector of cutter compensation lies otherwise to its span than declared.",
    verdicts: Verdicts::contouring("COMP-03", Severity::Info),
    clauses: &[Clause::Iso2539("5")],
    page: page!("COMP-03"),
};

/// Said once, with how many spans it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let found = || {
        tape.execution.events.iter().filter_map(|event| match event.kind {
            EventKind::VectorAside { tangential, other } => Some((event.block, tangential, other)),
            _ => None,
        })
    };
    let Some((block, tangential, _)) = found().next() else { return };
    // The other kind is the answer only where it fits them all, from the first vector of the tape on.
    let vector = Traits::address(b'P').with(Traits::address(b'Q')).with(Traits::address(b'R'));
    let is_first = !tape.reading.blocks[..block].iter().any(|block| block.traits.any(vector));
    let other = is_first && found().all(|(.., other)| other);
    let (wanted, opposite) = match tangential {
        true => ("tangent", CompensationVector::Normal),
        false => ("normal", CompensationVector::Tangent),
    };
    let hint = match other {
        true => format!("; it is {} to it. Clause 5 leaves that to the builder: state which it is.", opposite.word()),
        false => ". Correct it, or give it anew where the direction changes.".to_owned(),
    };
    let message = format!("The vector P, Q, R is not {wanted} to the start of its span{hint}");
    let mut format = tape.control.format.clone();
    format.itemized.compensation_vector = Some(opposite);
    let reported = sink.report(&RULE, super::vector_words(tape, block), message).count(found().count());
    if other {
        let title = format!("Read it as {} (compensationVector: {})", opposite.title(), opposite.word());
        reported.fix(|| Fix::reformat(title, format));
    }
}
