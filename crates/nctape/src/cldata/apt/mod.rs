//! The CL text of today's CAM systems (`GOTO / 1.0, 2.0, 3.0`), turned into the reference language of ISO 3592.
//!
//! The text is that of APT: a word, a `/`, its arguments between commas; `$` at the end of a line goes on with the next
//! one, `$$` begins a comment. It is no part of the standard. What each statement becomes follows the records that APT
//! processors write for it; a statement that has no record is kept, as the original statement of a 1000 record (6.2),
//! and said.

mod statement;
mod write;

use statement::{Statement, statements, text_of};
use std::ops::Range;
use write::Writer;

/// CL text as reference language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Translated {
    /// The reference language: one record a line, the file ended.
    pub text: String,
    /// From each statement, in bytes of the CL text, to its records, in bytes of the reference language.
    pub map: Vec<(Range<usize>, Range<usize>)>,
    /// The statements that became no command.
    pub faults: Vec<Fault>,
}

/// A statement that became no command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Where it stands in the CL text.
    pub range: Range<usize>,
    /// What was found and what is allowed.
    pub message: String,
}

/// An argument of a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Argument<'a> {
    /// A number, as written.
    Number(&'a str),
    /// A word of letters alone.
    Word(String),
    /// Any other text: a name with digits, or what stood between apostrophes.
    Text(&'a str),
}

/// The text begins as CL text does, not as records do: its first statement is a word of letters, alone or with a `/`.
pub fn is_cl_text(text: &str) -> bool {
    let Some(first) = statements(text).into_iter().find(|statement| !statement.is_aside) else { return false };
    text_of(&first.joined).is_some() || head_of(&first.joined).is_some_and(|(word, _)| word.len() >= 3)
}

/// Turns CL text into the reference language. It never fails: a statement that cannot be read is kept and said.
pub fn translate(text: &str) -> Translated {
    let mut writer = Writer::default();
    let (mut map, mut faults) = (Vec::new(), Vec::new());
    for statement in statements(text) {
        let from = writer.text.len();
        match command(&mut writer, &statement) {
            Ok(()) => {}
            Err(_) if statement.is_aside => {}
            Err(message) => {
                writer.origin(statement.line, Some(&statement.joined));
                faults.push(Fault { range: statement.range.clone(), message });
            }
        }
        if writer.text.len() > from {
            map.push((statement.range, from..writer.text.len()));
        }
    }
    Translated { text: writer.finish(), map, faults }
}

/// Writes the records of one statement; where it has none, what is wrong with it.
fn command(writer: &mut Writer, statement: &Statement) -> Result<(), String> {
    if let Some((word, text)) = text_of(&statement.joined).filter(|_| !statement.is_aside) {
        writer.origin(statement.line, None);
        writer.command(word, &[Argument::Text(text)]);
        return Ok(());
    }
    let (word, rest) = head_of(&statement.joined).ok_or_else(|| {
        format!("{:?} is no statement: a word of letters is allowed, then / and its arguments.", statement.joined)
    })?;
    // Of what CAM systems put into comments, only the cutter is of use to a post-processor.
    if statement.is_aside && word != "CUTTER" {
        return Err(String::new());
    }
    let arguments = arguments(rest)?;
    let numbers = || numbers(&word, rest, &arguments);
    match word.as_str() {
        "GOTO" | "FROM" | "GODLTA" => {
            let numbers = numbers()?;
            let subtype = match word.as_str() {
                "FROM" => 3,
                "GODLTA" => 4,
                _ => 5,
            };
            if !matches!(numbers.len(), 3 | 6) {
                let count = numbers.len();
                return Err(format!("{word} has {count} numbers: X, Y and Z are allowed, or these and the tool axis."));
            }
            // A point with a tool axis: the records hold six values while MULTAX is on.
            if numbers.len() == 6 {
                writer.multax(statement.line, true);
            }
            writer.origin(statement.line, None);
            writer.tool_position(subtype, &numbers);
        }
        "CIRCLE" => {
            let numbers = numbers()?;
            if numbers.len() != 7 {
                let count = numbers.len();
                return Err(format!("CIRCLE has {count} numbers: centre, axis and radius are allowed, seven in all."));
            }
            writer.origin(statement.line, None);
            writer.circle(&numbers);
        }
        "CUTTER" | "INTOL" | "OUTTOL" => {
            let numbers = numbers()?;
            let subtype = match word.as_str() {
                "CUTTER" => 6,
                "INTOL" => 4,
                _ => 5,
            };
            writer.origin(statement.line, None);
            writer.information(subtype, &numbers);
        }
        "CUT" | "DNTCUT" if arguments.is_empty() => {
            writer.origin(statement.line, None);
            writer.cut_flag(word == "CUT");
        }
        "UNITS" => {
            let unit = match &arguments[..] {
                [Argument::Word(unit)] => unit_code(unit),
                _ => None,
            };
            let unit = unit.ok_or_else(|| format!("UNITS has {rest:?}: MM, CM, INCHES and FEET are allowed."))?;
            writer.origin(statement.line, None);
            writer.unit(unit);
        }
        "MULTAX" => {
            let on = match &arguments[..] {
                [] => true,
                [Argument::Word(word)] if word == "ON" => true,
                [Argument::Word(word)] if word == "OFF" => false,
                _ => return Err(format!("MULTAX has {rest:?}: ON and OFF are allowed, or nothing.")),
            };
            writer.multax(statement.line, on);
        }
        "FINI" => {
            writer.origin(statement.line, None);
            writer.end();
        }
        _ => {
            writer.origin(statement.line, None);
            writer.command(&word, &arguments);
        }
    }
    Ok(())
}

/// The arguments of a statement that takes numbers alone.
fn numbers<'a>(word: &str, rest: &str, arguments: &[Argument<'a>]) -> Result<Vec<&'a str>, String> {
    let number = |argument: &Argument<'a>| if let Argument::Number(number) = *argument { Some(number) } else { None };
    let all: Option<Vec<&str>> = arguments.iter().map(number).collect();
    all.filter(|all| !all.is_empty()).ok_or_else(|| format!("{word} has {rest:?}: numbers between commas are allowed."))
}

/// The code of a unit in a 9000 record of subtype 9, as the processor of CAM-I's APT4 writes it.
fn unit_code(word: &str) -> Option<u8> {
    match word {
        "MM" => Some(1),
        "CM" => Some(2),
        "INCHES" | "INCH" => Some(3),
        "FEET" => Some(4),
        _ => None,
    }
}

/// The word of a statement in capitals, and what stands behind its `/`.
fn head_of(joined: &str) -> Option<(String, &str)> {
    let end = joined.find(|character: char| !character.is_ascii_alphabetic()).unwrap_or(joined.len());
    let rest = joined[end..].trim_start();
    let rest = if rest.is_empty() { rest } else { rest.strip_prefix('/')? };
    (end >= 2).then(|| (joined[..end].to_ascii_uppercase(), rest.trim()))
}

/// The arguments between the commas.
fn arguments(rest: &str) -> Result<Vec<Argument<'_>>, String> {
    let mut all = Vec::new();
    let mut left = rest;
    while !left.is_empty() {
        let (one, behind) = match left.strip_prefix('\'') {
            Some(open) => {
                let end = open
                    .find('\'')
                    .ok_or_else(|| format!("{left:?} has an apostrophe, and none that ends the text."))?;
                let behind = open[end + 1..].trim_start();
                (Argument::Text(&open[..end]), behind)
            }
            None => {
                let end = left.find(',').unwrap_or(left.len());
                (argument(left[..end].trim())?, &left[end..])
            }
        };
        all.push(one);
        left = match behind.strip_prefix(',') {
            Some(more) => more.trim_start(),
            None if behind.is_empty() => behind,
            None => return Err(format!("{behind:?} stands behind a text: a comma is allowed.")),
        };
    }
    Ok(all)
}

fn argument(piece: &str) -> Result<Argument<'_>, String> {
    if is_number(piece) {
        return Ok(Argument::Number(piece));
    }
    let named = |allowed: fn(&char) -> bool| !piece.is_empty() && piece.chars().all(|character| allowed(&character));
    if piece.len() >= 2 && named(char::is_ascii_alphabetic) {
        return Ok(Argument::Word(piece.to_ascii_uppercase()));
    }
    if named(|character| character.is_ascii_alphanumeric() || matches!(character, '_' | '-' | '.')) {
        return Ok(Argument::Text(piece));
    }
    Err(format!("{piece:?} is no argument: a number, a word or a text between apostrophes is allowed."))
}

/// Digits, with or without sign, point and exponent.
fn is_number(piece: &str) -> bool {
    let bytes = piece.as_bytes();
    let signed = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let (mantissa, exponent) = match piece[signed.min(piece.len())..].split_once(['E', 'e']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (&piece[signed.min(piece.len())..], None),
    };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let exponent = exponent.is_none_or(|exponent| digits(exponent.strip_prefix(['+', '-']).unwrap_or(exponent)));
    all(whole) && all(fraction) && !(whole.is_empty() && fraction.is_empty()) && exponent
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand, after the forms of each record.
    #[test]
    fn statements_become_the_records_that_processors_write() {
        let text = "FROM / 0, 0.5, -1.50\nMULTAX\nGOTO/1,2,3,0,0,1\nGOTO/1,2,4\nMULTAX/OFF\nDNTCUT\nCUT\nINTOL/.01\n\
                    UNITS/INCHES\nspindl/rpm,500,clw\nPPRINT it's done\nMACHIN/MILL2,1\nFINI\n";
        let records: Vec<String> =
            translate(text).text.lines().filter(|line| !line.contains(",1000,")).map(after_number).collect();
        let expected = [
            "5000,3,'',0,.,.5,-1.5;",
            "9000,2,1;",
            "5000,5,'',0,1.,2.,3.,.,.,1.;",
            "5000,5,'',0,1.,2.,4.,.,.,1.;",
            "9000,2,0;",
            "6000,1,1;",
            "6000,1,0;",
            "6000,4,.01;",
            "9000,9,3;",
            "20000,0,SPINDL,RPM,500.,CLW;",
            "20000,0,PPRINT,'it''s done';",
            "20000,0,MACHIN,'MILL2',1.;",
            "14000;",
            ":",
        ];
        assert_eq!(records, expected);
    }

    fn after_number(line: &str) -> String {
        line.split_once(',').map_or(line, |(_, rest)| rest).to_owned()
    }

    #[test]
    fn what_is_no_statement_is_kept_and_said() {
        let found = translate("GOTO / 1.0, 2.0\n12 = 5\nUNITS / YARDS\nGOTO / 1, 2, #\nFINI\n");
        let kept: Vec<&str> = found.text.lines().filter(|line| line.matches('\'').count() == 4).collect();
        assert_eq!(
            kept,
            [
                "1,1000,1,'','GOTO / 1.0, 2.0';",
                "2,1000,2,'','12 = 5';",
                "3,1000,3,'','UNITS / YARDS';",
                "4,1000,4,'','GOTO / 1, 2, #';"
            ]
        );
        assert_eq!(found.faults.len(), 4);
        assert!(found.faults[0].message.starts_with("GOTO has 2 numbers"), "{:?}", found.faults[0]);
    }

    #[test]
    fn cl_text_is_told_from_records() {
        assert!(is_cl_text("$$* CL file\nPARTNO / A\n"));
        assert!(is_cl_text("goto / 1.0, 2.0, 3.0\n"));
        assert!(!is_cl_text("1,20000,0,PARTNO,'A';\n2,14000;\n:\n"));
        assert!(!is_cl_text("N001 G01 X+001000\n"));
        assert!(!is_cl_text(""));
    }
}
