//! TAPE-06 / TAPE-07: the number behind the program start is not what the format foresees.

use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "undeclared-program-number",
    title: "The number behind the program start is not what the format foresees.",
    verdicts: Verdicts::contouring("TAPE-06", Severity::Error).and_iso1058("TAPE-07", Severity::Warning),
    clauses: &[Clause::Iso2539("B.2 note 3"), Clause::Iso1058("B.2 note 5")],
    page: page!("TAPE-06"),
};

pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let declared = tape.control.format.itemized.program_number_digits.unwrap_or(0);
    for mark in tape.reading.programs() {
        let digits = tape.text[mark.number.clone()].chars().filter(char::is_ascii_digit).count();
        let standard = tape.control.standard();
        let message = match (digits, standard) {
            (0, _) => continue,
            (_, Standard::Iso1058) => {
                "ISO 1058 has no program number behind %. Take the digits out, or put them into a comment.".to_owned()
            }
            (_, _) if declared == 0 => format!(
                "The program number has {}; the itemized data foresees none. Declare how many digits it has, or take \
                 the number out.",
                super::super::prelude::digits(digits as u16)
            ),
            (_, _) if digits != usize::from(declared) => format!(
                "The program number has {}; the itemized data declares {declared}. Write it with {declared}.",
                super::super::prelude::digits(digits as u16)
            ),
            _ => continue,
        };
        let reported = sink.report(&RULE, mark.number.clone(), message);
        if standard == Standard::Iso1058 {
            reported.fix(|| Fix::replace("Take the digits out", mark.number.clone(), ""));
        } else if let Some(digits) = u8::try_from(digits).ok().filter(|digits| *digits <= 9) {
            let mut format = tape.control.format.clone();
            format.itemized.program_number_digits = Some(digits);
            reported.fix(|| Fix::reformat(format!("Declare {digits} digits"), format));
        }
    }
}
