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

#[test]
fn a_faulty_preparatory_function_may_have_been_the_interpolation_code() {
    check(&[
        ("2539", "%\nN001 GO1 X+001000 F0300 M30\n", "WORD-14@8-9"),
        ("2539", "%\nN001 G0l X+001000 F0300 M30\n", "WORD-23@9-10"),
        ("2539", "%\nN001 G X+001000 F0300 M30\n", "WORD-10@7-8"),
        ("2539", "%\nN001 G#1 X+001000 F0300 M30\n", "TAPE-08@8-9"),
        ("2539", "%\nN001 G0.1 X+001000 F0300 M30\n", "NUM-03@9-10"),
        ("2539", "%\nN001 G05 X+001000 F0300 M30\n", "FUN-01@7-10"),
        ("2539", "%\nN001 G99 X+001000 F0300 M30\n", "FUN-01@7-10"),
        ("2539", "%\nN001 G01;X+001000 F0300 M30\n", "TAPE-08@10-11"),
        ("2539", "%\nN001 01 X+001000 F0300 M30\n", "WORD-11@2-9"),
        ("2539", "%\nN00101 X+001000 F0300 M30\n", "WORD-11@2-8"),
        // In an earlier block, too, up to the end of the program.
        ("2539", "%\nN001 GO1\nN002 X+001000 F0300 M30\n", "WORD-14@8-9"),
        (
            "2539",
            "%\nN001 GO1 X+001000 F0300 M30\n%\nN001 X+001000 F0300 M30\n",
            "WORD-14@8-9 FUN-05@32-55 MOT-18@32-55",
        ),
        // A parameter alone moves nothing.
        ("2539", "%\nN001 I+000500 M30\n", "MOT-16@7-15"),
    ]);
}

#[test]
fn a_word_that_stands_twice_is_not_out_of_order_too() {
    check(&[
        ("2539", "%\nN001 G00 X+001000 Y+001000 X+002000 M30\n", "WORD-05@29-37"),
        ("1058", "%\nN001 G00 X+001000 Y+001000 X+002000 M30\n", "WORD-06@29-37"),
        ("2539", "%\nN001 G01 X+001000 G01 F0300 M30\n", "WORD-05@20-23"),
        ("2539", "%\nN001 G01 G90 M30\n", "WORD-05@11-14"),
        // Behind it others may still stand out of order.
        ("2539", "%\nN001 G00 Y+001000 Z+001000 Y+002000 X+001000 M30\n", "WORD-05@29-37 WORD-03@38-46"),
        // ISO 1058 forbids no second G; that it stands behind a dimension is said then.
        ("1058", "%\nN001 G00 X+001000 G60 M30\n", "WORD-02@20-23"),
    ]);
}

#[test]
fn a_word_has_one_fault() {
    check(&[
        ("2539", "%\nO1234\nN001 M30\n", "WORD-14@2-7"),
        ("2539", "%\nH01\nN001 M30\n", "WORD-13@2-5"),
        ("1058", "%\nN001 G01 X+001000 F00300 M30\n", "FEED-07@20-26"),
        ("1058", "%\nN001 S6000 M03\nN002 M30\n", "FEED-07@7-12"),
        ("1058", "%\nN001 S600 M03\nN002 M30\n", "FEED-06@7-11"),
    ]);
}

#[test]
fn an_end_of_block_before_the_program_start_is_said_at_the_program_start() {
    for name in ["2539", "1058", "274"] {
        check(&[
            (name, "\n%\nN001 M30\n", "TAPE-04@1-2"),
            (name, "\n\n\n%\nN001 M30\n", "TAPE-12@1-2 TAPE-12@2-3 TAPE-04@3-4"),
        ]);
    }
    check(&[("2539", "(A))\nN001 M30\n", "CTRL-02@3-4")]);
}

#[test]
fn a_slash_without_a_block_skips_nothing() {
    for name in ["2539", "274"] {
        check(&[
            (name, "%\n/\nN001 M30\n", "SKIP-01@2-3"),
            (name, "%\nN001 M30\n/\n", "SKIP-01@11-12"),
            (name, "%\nN001 M30\n/", "SKIP-01@11-12"),
        ]);
    }
    check(&[("1058", "%\n/\nN001 M30\n", "SKIP-02@2-3")]);
}

#[test]
fn a_character_without_a_row_in_the_code_is_left_off_the_tape() {
    let mut eia = format("2539");
    eia.itemized.code = Some(nctape::format::TapeCode::Eia);
    assert_eq!(said("%\n:001 G00 X+000000 M30\n", &eia), "TAPE-08@2-3");
    // Annex B has capital letters, whatever the code.
    assert_eq!(said("%\nn001 g00 x+001000\nn002 m30\n", &eia), "TAPE-09@2-6×5");
}

#[test]
fn the_program_number_begins_at_its_first_digit() {
    check(&[
        ("2539", "% 12\nN001 M30\n", "TAPE-06@2-4"),
        ("2539", "% 1 2 \nN001 M30\n", "TAPE-06@2-5"),
        ("1058", "% 12\nN001 M30\n", "TAPE-07@2-4"),
    ]);
}

#[test]
fn what_lost_its_control_out_is_of_the_comment() {
    check(&[
        ("2539", "*SETUP)N001G01*\nN002 M30\n", "CTRL-02@6-7"),
        ("2539", "%\nN001 G01 STEP 1 DIA 5) X+001000 F0300 M30\n", "CTRL-02@23-24"),
        ("2539", "%\nSETUP \u{1F600}) N001 M30\n", "TAPE-08@8-12 CTRL-02@12-13"),
        // Sound words are read: the ) itself is too much.
        ("2539", "%\nN001 G01 X+001000) Y+001000 F0300 M30\n", "CTRL-02@19-20"),
        ("2539", "%\nN001 G X+001000) F0300 M30\n", "WORD-10@7-8 CTRL-02@17-18"),
        // A comment that ended too early.
        ("2539", "*(A (B) C)N001G01*\nN002 M30\n", "CTRL-05@4-5"),
        ("2539", "%\nN001 (A (B) AND C) G01 X+001000 F0300 M30\n", "CTRL-05@10-11"),
        // One that ran over a line end into the comment of the next block.
        ("2539", "%\nN001 G01 (SETUP\n(B) N002 M30\n", "CTRL-06@11-12"),
        ("2539", "%\nN001 G01 (SETUP\nN002 X+001000 F0300\n(B) N003 M30\n", "CTRL-06@11-12×2"),
    ]);
}

#[test]
fn a_comment_that_swallowed_the_end_code_is_the_fault() {
    check(&[
        ("2539", "%\n(ABC\nN001 G01\nN002 M30 (END)\n", "CTRL-06@2-3×2 TAPE-12@2-31"),
        ("2539", "%\nN001 G00 X+001000 (A\nN002 G00 Y+001000 (B)\n", "TAPE-10@2-19 CTRL-06@20-21"),
    ]);
}

#[test]
fn a_label_is_passed_over() {
    for name in ["2539", "1058", "274"] {
        check(&[
            (name, "PLATE 12\n%\nN001 M30\n", "TAPE-08@0-8"),
            (name, "PLATE 12\n\nSIDE A (LEFT)\n%\nN001 M30\n", "TAPE-08@0-23"),
            (name, "PLATE 12\nN001 M30\n", "TAPE-08@0-8"),
            (name, "%PROG1\nN001 M30\n", "TAPE-08@1-6"),
            (name, "%PART A (LEFT) B C D\nN001 M30\n", "TAPE-08@1-7 TAPE-08@15-20"),
            (name, "\u{1F600}\n%\nN001 M30\n", "TAPE-08@0-4"),
        ]);
    }
    check(&[
        ("2539", "%N001 G00 X+001000 M30\n", "TAPE-01@1-22"),
        ("2539", "%12 PLATE\nN001 M30\n", "TAPE-06@1-3 TAPE-08@4-9"),
    ]);
}

#[test]
fn outside_of_the_program_text_and_comments_are_free() {
    for name in ["2539", "1058", "274"] {
        check(&[
            (name, "%\nN001 M30\n(50%:)\n", "TAPE-12@11-18"),
            (name, "%\nN001 M30\n(50%:)", ""),
            (name, "%\nN001 M30\n%\n(50%:)\n", "TAPE-12@13-20"),
            (name, "%\nN001 M30\n(5%)\n%\n(6%)\nN002 M30\n", "TAPE-12@11-16 TAPE-12@18-23 CTRL-04@20-21"),
            (name, "%\nN001 M30\nGARBAGE\n", "TAPE-11@11-18"),
            (name, "%\nN001 M30\nEND OF TOOL TAPE", "TAPE-11@11-27"),
            (name, "%\nN001 M30\nN002 G01 X\n", "TAPE-11@11-21"),
            (name, "%\nN001 M30\nTHE END!\n", "TAPE-11@11-18 TAPE-08@18-19"),
        ]);
    }
    // A block that may have been meant is checked.
    check(&[("2539", "%\nN001 M30\nN002 M3\n", "TAPE-11@11-18 NUM-17@16-18")]);
}

#[test]
fn a_system_without_addresses_counts_its_tabs_once() {
    check(&[
        ("2539 T", "%\n\t001\t01\t+015000\t+015000\t0300\n002\t\t\t\t\t30\n", "SEQ-06@2-3"),
        ("1058 T", "%\n\t001\t01\t+015000\t+015000\t0300\n002\t\t\t\t\t30\n", "SEQ-06@2-3"),
        // No sequence number, and a tab in its place.
        ("1058 T", "%\n\t01\t+015000\t+015000\t0300\n002\t\t\t\t\t30\n", ""),
        // Zero is one zero at least.
        ("2539 T", "%\n001\t01\t0\t0\t0300\n002\t\t+015000\t+0\t\t30\n", ""),
        ("1058 T", "%\n001\t00\t0\t000\t0300\n002\t\t+015000\t+015000\t\t30\n", ""),
        ("2539 T", "%\n001\t01\t0000000\t0\t0300\n002\t\t\t\t\t30\n", "NUM-02@9-16"),
        // The end code in the wrong column.
        ("2539 T", "%\n001\t01\t+015000\t\t0300\n002\t\t\t\t30\n", "TAB-02@30-32"),
        ("2539 T", "%\n001\t01\t+015000\t\t0300\n002\t\t\t\t\t\t30\n", "TAB-03@31-32"),
        ("2539 S", "%\nN001\t\t\t\t\t\t\t\tM30\n", "TAB-03@11-12"),
        // A tab that is lost before a sign.
        ("2539 T", "%\n001\t01\t+015000+015000\t0300\n002\t\t\t\t\t30\n", "TAB-02@16-23"),
        ("2539 T", "%\n001\t01\t+0150+00\t+015000\t0300\n002\t\t\t\t\t30\n", "NUM-13@14-15"),
        ("2539 T", "%\n001\t01\t+015000+00\t0300\n002\t\t\t\t\t30\n", "NUM-13@16-17"),
        // Addresses where the columns tell the words. A colon stands for N and is not told by the column.
        ("2539 T", "%\nN001\tG00\tX+015000\tY+015000\n002\t\t\t\t\tM30\n", "TAB-09@2-3×5"),
        ("2539 T", "%\n:001\t00\t+015000\t+015000\t\t30\n", ""),
    ]);
}
