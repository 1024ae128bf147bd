//! A fault is reported once, at its cause: short tapes with a slip in them, and all that is said of each.
//!
//! What a tape shows is written `id@from-to`, in bytes, in the order of the report; `×n` is the count of a finding that
//! is said once for several places.

use nctape::{Format, Standard, Tape};
use std::fmt::Write;

/// A format by its short name.
fn format(name: &str) -> Format {
    let (standard, classification, detail) = match name {
        "2539" => (Standard::Iso2539, Some("CAM 333"), "N3G2X+42Y+42Z+42I+42J+42K+42F4S3T2M2*"),
        "2539 S" => (Standard::Iso2539, Some("CSM 222"), "N3.G2.X+33.Y+33.F4.M2*"),
        "2539 T" => (Standard::Iso2539, Some("CTM 222"), "N3.G2.X+33.Y+33.F4.M2*"),
        "1058" => (Standard::Iso1058, Some("LAM 333"), "N3G2X+42Y+42Z+42F4S3T2M2*"),
        "1058 T" => (Standard::Iso1058, Some("LTM 222"), "N3.G2.X+33.Y+33.F4.M2*"),
        "274" => (Standard::Rs274, None, "n3 g2 x+42 y+42 i+42 j+42 f4 s3 t2 m2*"),
        _ => panic!("{name:?} is no format"),
    };
    let format = Format::new(standard, detail);
    match classification {
        Some(classification) => format.classified(classification),
        None => format,
    }
}

/// All that is said of a tape.
fn said(text: &str, format: &Format) -> String {
    let tape = Tape::new(text, format);
    let mut said = String::new();
    for found in tape.diagnostics() {
        let blank = if said.is_empty() { "" } else { " " };
        write!(said, "{blank}{}@{}-{}", found.id, found.range.start, found.range.end).unwrap();
        if found.count > 1 {
            write!(said, "×{}", found.count).unwrap();
        }
    }
    said
}

/// Each line: the format, the tape, all that is said of it.
fn check(cases: &[(&str, &str, &str)]) {
    let mut faults = String::new();
    for &(name, text, wanted) in cases {
        let found = said(text, &format(name));
        if found != wanted {
            write!(faults, "\n{name}: {text:?}\n  wanted {wanted}\n  found  {found}").unwrap();
        }
    }
    assert!(faults.is_empty(), "{faults}");
}

#[test]
fn behind_a_comment_that_nothing_closes_all_is_comment() {
    check(&[
        ("2539", "%\nN001 G01 (SETUP\nN002 X+001000 F0300\nN003 M30\n%\n", "CTRL-01@11-12"),
        ("2539", "%\nN001 G01 (SETUP\n:002 X+001000 F0300\n%\n", "CTRL-01@11-12"),
        ("2539", "%\nN001 G01 (A (B\nN003 M30\n", "CTRL-01@11-12"),
        ("2539", "(A\n%\nN001 M30\n", "CTRL-01@0-1"),
        // What stands in a comment before it is still said.
        ("2539", "%\nN001 G01 (5%) (SETUP 5%\nN003 M30\n", "CTRL-04@13-14 CTRL-01@16-17"),
    ]);
}

#[test]
fn what_holds_no_word_is_no_program() {
    for name in ["2539", "1058", "274"] {
        check(&[
            (name, "%\nN001 M30\n%\n\n", "TAPE-12@13-14"),
            (name, "%\r\nN001 M30\r\n%\r\n\r\n", "TAPE-12@16-18"),
            (name, "%\nN001 M30\n%\n(END)\n", "TAPE-12@13-19"),
            (name, "%\nN001 M30\n%\n\n%\nN002 M30\n", "TAPE-12@13-14"),
        ]);
    }
    check(&[
        // Without a word at all there is no end code either, and that is said once.
        ("2539", "%\n\n", "TAPE-10@2-3 TAPE-12@2-3"),
        ("2539", "%\nN001 G00 X+001000\n%\n\n", "TAPE-10@2-19 TAPE-12@22-23"),
    ]);
}
