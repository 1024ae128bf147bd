//! A text that is no tape at all: said once, and nothing else of it is checked.

use super::prelude::*;
use super::{number, tape};
use crate::cldata::apt::translate;
use crate::convert::from_decimal;
use crate::diagnostic::Language;
use crate::format::DIMENSION_LETTERS;
use std::ops::Range;

/// Tells whether the text is something else than a tape, and says so.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) -> bool {
    todays_code(tape, sink) || source(tape, sink)
}

/// Bytes of a text that is offered as a tape: to know what the fix writes, the text is converted at every check.
const MOST_CONVERTED: usize = 100_000;

/// Today's G-code: most dimension words, those that are a mere 0 left aside, have a decimal point. One such word with
/// all the digits of the format is a slip, and NUM-03 mends it.
fn todays_code(tape: &TapeView<'_>, sink: &mut Sink<'_>) -> bool {
    if !tape.seen.any(Traits::DECIMAL_SIGN) {
        return false;
    }
    let (mut dimensions, mut zeros, mut points, mut whole, mut first) = (0_usize, 0_usize, 0_usize, 0_usize, None);
    for (block, word) in tape.words() {
        if !DIMENSION_LETTERS.contains(word.letter()) || word.fault == NumberFault::Empty {
            continue;
        }
        dimensions += 1;
        // X0 is a habit of today's code, and says nothing of the decimal sign.
        zeros += usize::from(word.digits == 1 && tape.text[tape.range(block, word)].ends_with('0'));
        if let NumberFault::DecimalSign(at) = word.fault {
            let at = block.range.start + at as usize;
            if tape.text.as_bytes()[at] == b'.' {
                points += 1;
                let width = tape.control.designation(word.address).map(|designation| u16::from(designation.width()));
                whole += usize::from(width == Some(word.digits));
                first = first.or(Some(at));
            }
        }
    }
    let Some(at) = first.filter(|_| points - whole.min(1) > 0 && 2 * points > dimensions - zeros) else { return false };
    let message = format!(
        "{points} of {dimensions} dimension words {} a decimal point: this is today's G-code, not a tape. A tape has \
         no decimal sign; the format says where it is understood. Nothing else is checked.",
        if points == 1 { "has" } else { "have" }
    );
    let converted = || {
        let written = from_decimal(tape.text, &tape.control.format).text;
        Fix::replace("Write it as a tape of this format", 0..tape.text.len(), written)
    };
    let fix = (tape.text.len() <= MOST_CONVERTED).then(converted);
    sink.report(&number::decimal_sign::RULE, at..at + 1, message).count(points).fixes(fix);
    true
}

/// How many lines are looked at before the text is taken for a tape.
const LINES_ENOUGH: usize = 200;

/// CLDATA or APT: most lines are statements of it.
pub(crate) fn is_source(text: &str) -> bool {
    let (statements, lines) = count(statements(text).take(LINES_ENOUGH));
    statements >= 2 && 2 * statements > lines
}

fn source(tape: &TapeView<'_>, sink: &mut Sink<'_>) -> bool {
    if !is_source(tape.text) {
        return false;
    }
    let Some((from, statement)) = statements(tape.text).find(|line| is_statement(line.1)) else { return false };
    let (count, _) = count(statements(tape.text));
    let message = "The text is APT source or CLDATA, which is written before it is known what control will run it. A \
                   postprocessor makes a tape of it. Nothing else is checked.";
    let fix = match apt(tape.text) {
        Some(_) => in_records(tape.text, "Turn it into CLDATA and open that"),
        None => Some(Fix::open_as(Language::Cldata, "Open it as CLDATA", None)),
    };
    sink.report(&tape::foreign_character::RULE, from..from + statement.len(), message.to_owned())
        .count(count)
        .fixes(fix);
    true
}

/// Turns the CL text of a CAM system into records. Not offered where most statements have none, as in a part program
/// that only a processor understands.
pub(crate) fn in_records(text: &str, title: &str) -> Option<Fix> {
    if text.len() > MOST_CONVERTED {
        return None;
    }
    let found = translate(text);
    (2 * found.faults.len() < found.map.len())
        .then(|| Fix::open_as(Language::Cldata, title, Some((0..text.len(), found.text))))
}

fn count<'a>(lines: impl Iterator<Item = (usize, &'a str)>) -> (usize, usize) {
    lines.fold((0, 0), |(statements, lines), (_, line)| (statements + usize::from(is_statement(line)), lines + 1))
}

/// The lines on which a statement may begin, each with its place: not empty, no remark (`$$`), and not going on with
/// the line before, which then ends with `$`.
fn statements(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut at = 0;
    let mut goes_on = false;
    text.split_inclusive(['\n', '\r']).filter_map(move |line| {
        let from = at + line.len() - line.trim_start().len();
        at += line.len();
        let line = line.trim();
        if line.is_empty() || line.starts_with("$$") {
            return None;
        }
        let begins = !std::mem::replace(&mut goes_on, line.ends_with('$'));
        begins.then_some((from, line))
    })
}

/// The first statement of a text that is the source of a part program, and how many there are: most of its lines are
/// statements of APT, and at least one of them has a `/`.
pub(crate) fn apt(text: &str) -> Option<(Range<usize>, usize)> {
    let of_apt = |line: &str| !is_record(line) && is_statement(line);
    let (mut first, mut found, mut lines, mut slash) = (None, 0, 0, false);
    for (from, line) in statements(text).take(LINES_ENOUGH) {
        lines += 1;
        if of_apt(line) {
            first = first.or(Some(from..from + line.len()));
            found += 1;
            slash |= line.contains('/');
        }
    }
    let first = first.filter(|_| slash && 2 * found > lines)?;
    Some((first, statements(text).filter(|(_, line)| of_apt(line)).count()))
}

/// A record of CLDATA, `12,5000,5,…`, or a statement of APT: a word of three letters or more that `/` or nothing
/// follows, `GOTO/10,20`, `P1 = POINT/10,20`, `FINI`.
fn is_statement(line: &str) -> bool {
    if is_record(line) {
        return true;
    }
    // A line number, or a symbol before `=`.
    let behind = line.trim_start_matches(|digit: char| digit.is_ascii_digit()).trim_start();
    if behind.len() < line.len() && behind.starts_with(',') {
        return false;
    }
    let statement = behind.split_once('=').map_or(behind, |(_, statement)| statement).trim_start();
    let letters = statement.bytes().take_while(u8::is_ascii_alphabetic).count();
    let rest = statement[letters..].trim_start();
    letters >= 3 && (rest.is_empty() || rest.starts_with('/') || rest.starts_with("$$"))
}

/// A record of CLDATA.
fn is_record(line: &str) -> bool {
    let digits = line.bytes().take_while(u8::is_ascii_digit).count();
    let Some(record) = line[digits..].trim_start().strip_prefix(',').filter(|_| digits > 0) else { return false };
    let record = record.trim_start();
    let class = record.bytes().take_while(u8::is_ascii_digit).count();
    matches!(class, 4 | 5) && record[class..].trim_start().starts_with([',', ';'])
}

#[cfg(test)]
mod tests {
    use crate::{Format, Standard, Tape};

    fn found(text: &str) -> Vec<(&'static str, usize, usize)> {
        let format = Format::new(Standard::Iso2539, "N3G2X+42Y+32F4M2*").classified("CAM 222");
        let tape = Tape::new(text, &format);
        tape.diagnostics().iter().map(|found| (found.id, found.range.start, found.count)).collect()
    }

    #[test]
    fn todays_code_is_offered_as_a_tape() {
        let format = Format::new(Standard::Iso2539, "N3G2X+42Y+32F4M2*").classified("CAM 222");
        let tape = Tape::new("G21\nG1 X10.5 Y-3. F300\nM30\n", &format);
        let edit = &tape.diagnostics()[0].fixes[0].edits[0];
        assert_eq!(edit.range, 0..tape.text().len());
        assert_eq!(edit.insert, "%\nN001 G01 X+001050 Y-00300 F0300\nN002 M30\n");
    }

    #[test]
    fn todays_code_is_said_once_at_the_first_point() {
        assert_eq!(found("G21\nG0 X10.5 Y20. Z5\nG1 Z-1.0 F200\nM30\n"), [("NUM-03", 10, 3)]);
        assert_eq!(found("G0 X0 Y0\nG1 X1.5 Y2.5\n"), [("NUM-03", 14, 2)]);
        assert_eq!(found("%\nG0 X10.5\nM30\n"), [("NUM-03", 8, 1)]);
        assert_eq!(found("%\nG0 X10.5 Y20\nM30\n").len(), 5, "one of two is not most");
    }

    #[test]
    fn one_decimal_sign_is_a_slip() {
        let slip = found("%\nN001 G00 X+001000 Y+02000\nN002 X+0010.00 M30\n");
        assert_eq!(slip, [("NUM-03", 39, 1)]);
        assert_eq!(found("%\nN001 G00 X+0010.00 M30\n"), [("NUM-03", 17, 1)]);
    }

    #[test]
    fn apt_and_cldata_are_said_once_at_the_first_statement() {
        let apt = "$$ A PLATE\nPARTNO/PLATE\nP1 = POINT/10,20\nFROM/P1\nGOTO/ 10., $\n 20., 0.\nFINI\n";
        assert_eq!(found(apt), [("TAPE-08", 11, 5)]);
        let cldata = "1,20000,0,PARTNO,'EXAMPLE';\n2,5000,5,'',0,1.,2.,3.;\n3,14000;\n:";
        assert_eq!(found(cldata), [("TAPE-08", 0, 3)]);
    }

    #[test]
    fn a_tape_with_remarks_is_a_tape() {
        let tape = "PLATE\nFACE/SIDE\n%\nN001 G00 X+001000\nN002 X+000000\nN003 M30\n";
        assert_eq!(found(tape), [("TAPE-08", 0, 1)], "the remarks are a label");
    }
}
