//! Rows and characters, both ways.

use nctape::code::{Code, DecodeOptions, EndOfBlock, RowIssueKind, decode, encode};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const CODES: [Code; 2] = [Code::Iso, Code::Eia];

/// The characters of a listing that a code has, but those that a control disregards and the parentheses, between
/// which a blank is punched.
fn characters(code: Code) -> Vec<char> {
    let in_code = |character: &char| code.row(*character).is_some();
    ('!'..='~').chain(['\t']).filter(|c| !c.is_ascii_lowercase() && !"()".contains(*c)).filter(in_code).collect()
}

fn rows(text: &str, code: Code) -> Vec<u8> {
    encode(text, code, EndOfBlock::Lf).bytes
}

#[test]
fn every_character_of_both_codes_survives_text_rows_text() {
    for code in CODES {
        for character in characters(code) {
            // A digit or % alone before the first end of block belongs to no block; behind a letter all are the same.
            let text = format!("%\nN{character}\n(A {character})\n");
            let decoded = decode(&rows(&text, code), DecodeOptions::default());
            assert_eq!((decoded.code, decoded.text.as_str()), (code, text.as_str()));
            assert!(decoded.issues.is_empty(), "{:?}", decoded.issues);
        }
    }
    assert_eq!(characters(Code::Iso).len(), 43 - 2 + 1, "43 glyphs, the parentheses apart, and the tab");
    assert_eq!(characters(Code::Eia).len(), 36 + 7 + 1, "36 letters and digits, % & + , - . / and the tab");
}

#[test]
fn no_row_is_a_character_of_both_codes() {
    for row in 1..=u8::MAX {
        let both = CODES.iter().all(|code| code.meaning(row).is_some());
        assert!(!both, "{row:02X}");
    }
}

#[test]
fn a_carriage_return_ends_blocks_where_there_is_no_line_feed() {
    let by_return = encode("%\nN001\n", Code::Iso, EndOfBlock::Cr).bytes;
    assert_eq!(decode(&by_return, DecodeOptions::default()).text, "%\nN001\n");
    // CR LF, as later controls punch: the carriage return is disregarded.
    let both: Vec<u8> = rows("%\nN001\n", Code::Iso)
        .into_iter()
        .flat_map(|row| if row == 0x0A { vec![0x8D, row] } else { vec![row] })
        .collect();
    assert_eq!(decode(&both, DecodeOptions::default()).text, "%\nN001\n");
}

#[test]
fn leader_trailer_and_label_are_passed_over() {
    let mut tape = vec![0u8; 20];
    // A letter cut as a picture: rows that are no characters.
    tape.extend([0x7E, 0x11, 0x11, 0x7E]);
    tape.extend([0u8; 20]);
    tape.extend(rows("%\nN001G01\n", Code::Eia));
    tape.extend([0x7F; 5]);
    tape.extend([0u8; 20]);
    let decoded = decode(&tape, DecodeOptions::default());
    assert_eq!(decoded.text, "%\nN001G01\n");
    assert!(decoded.issues.iter().all(|issue| issue.kind == RowIssueKind::Label), "{:?}", decoded.issues);
}

#[test]
fn blank_tape_within_an_eia_program_is_an_alarm_and_in_iso_it_is_not() {
    for (code, expected) in [(Code::Eia, vec![RowIssueKind::Blank]), (Code::Iso, vec![])] {
        let mut tape = rows("%\nN001G01\n", code);
        tape.insert(4, 0);
        let decoded = decode(&tape, DecodeOptions::default());
        assert_eq!(decoded.text, "%\nN001G01\n");
        assert_eq!(decoded.issues.iter().map(|issue| issue.kind).collect::<Vec<_>>(), expected);
    }
}

/// Track 8 taken away by a reader, or set in every row by a teleprinter: the characters are read all the same.
#[test]
fn a_tape_without_parity_is_read_and_said_to_have_none() {
    let text = "%\n(A B)\nN001G01X+01000\tF0300\nN002M30\n%\n";
    let good = rows(text, Code::Iso);
    let stripped: Vec<u8> = good.iter().map(|row| row & 0x7F).collect();
    let marked: Vec<u8> = good.iter().map(|row| row | 0x80).collect();
    let by_return = |rows: &[u8]| rows.iter().map(|&row| if row & 0x7F == 0x0A { row + 3 } else { row }).collect();
    let framed = |rows: &[u8], leader: u8| [&[leader; 30], rows, &[leader; 30]].concat();
    let cases: [Vec<u8>; 8] = [
        stripped.clone(),
        marked.clone(),
        framed(&stripped, 0x00),
        framed(&marked, 0x00),
        framed(&stripped, 0x7F),
        framed(&marked, 0x80),
        by_return(&stripped),
        by_return(&marked),
    ];
    for tape in cases {
        for code in [None, Some(Code::Iso)] {
            let decoded = decode(&tape, DecodeOptions { code, ..DecodeOptions::default() });
            assert_eq!((decoded.code, decoded.text.as_str()), (Code::Iso, text), "{}", decoded.reason);
            let kinds: Vec<_> = decoded.issues.iter().map(|issue| issue.kind).collect();
            assert_eq!(kinds, [RowIssueKind::NoParity]);
            assert!(code.is_some() || decoded.reason.contains("parity"));
        }
    }
}

#[test]
fn in_the_wrong_code_every_row_is_judged() {
    for (code, other) in [(Code::Iso, Code::Eia), (Code::Eia, Code::Iso)] {
        let tape = [vec![0; 10], rows("%\nN001G01\n", code), vec![0; 10]].concat();
        let decoded = decode(&tape, DecodeOptions { code: Some(other), ..DecodeOptions::default() });
        let judged: Vec<_> =
            decoded.issues.iter().filter(|it| it.kind == RowIssueKind::Parity).map(|it| it.row).collect();
        assert_eq!(judged, (10..tape.len() - 10).collect::<Vec<_>>());
        assert_eq!(decoded.text.chars().count(), judged.len());
    }
}

/// Tape without any end of block: a piece cut out of a program.
#[test]
fn damage_in_a_tape_without_end_of_block_is_no_label() {
    for code in CODES {
        let mut tape = rows("N001G01X+0100", code);
        tape[3] ^= 0x10;
        let decoded = decode(&tape, DecodeOptions { code: Some(code), ..DecodeOptions::default() });
        assert_eq!(decoded.text, "N00\u{FFFD}G01X+0100");
        assert!(decoded.issues.iter().any(|issue| issue.row == 3 && issue.kind == RowIssueKind::Parity));
    }
}

#[test]
fn all_eight_holes_are_a_delete_in_eia_code_too() {
    let mut tape = rows("%\nN001G01\n", Code::Eia);
    tape.insert(4, 0xFF);
    tape.push(0xFF);
    let decoded = decode(&tape, DecodeOptions::default());
    assert_eq!(decoded.text, "%\nN001G01\n");
    assert_eq!(
        decoded.issues.iter().map(|it| (it.row, it.kind)).collect::<Vec<_>>(),
        [(4, RowIssueKind::ForeignDelete)]
    );
}

#[test]
fn the_count_of_a_block_is_an_option() {
    // Y-1702's block has 29 characters: odd. The second block has 8: N026M02 and its end.
    let tape = rows("\nN025G01X-03216Y+00782F415M01\nN026M02\n", Code::Eia);
    assert_eq!(decode(&tape, DecodeOptions::default()).issues, []);
    let counted = decode(&tape, DecodeOptions { count_blocks: true, ..DecodeOptions::default() });
    let found: Vec<_> = counted.issues.iter().map(|issue| (issue.row, issue.kind)).collect();
    assert_eq!(found, [(29, RowIssueKind::OddBlock)]);
    assert_eq!(&counted.text[counted.issues[0].range.clone()], "\n");
}

/// Blocks of words, comments and tabs in the characters that both codes have.
fn tape() -> impl Strategy<Value = String> {
    let word = "\t?[A-Z][+-]?[0-9]{1,7}";
    let comment = "\\([A-Z0-9 +/-]{0,12}\\)";
    let block =
        prop::collection::vec(prop_oneof![6 => word, 1 => comment], 1..8).prop_map(|words| words.concat() + "\n");
    prop::collection::vec(block, 1..12).prop_map(|blocks| format!("%\n{}", blocks.concat()))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, failure_persistence: None, rng_seed: RngSeed::Fixed(2539), ..ProptestConfig::default() })]

    #[test]
    fn random_tapes_survive_text_rows_text(text in tape(), eia: bool) {
        let code = if eia { Code::Eia } else { Code::Iso };
        let decoded = decode(&rows(&text, code), DecodeOptions::default());
        prop_assert_eq!(decoded.code, code);
        prop_assert_eq!(&decoded.text, &text);
        prop_assert!(decoded.issues.is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 30, failure_persistence: None, rng_seed: RngSeed::Fixed(2539), ..ProptestConfig::default() })]

    #[test]
    fn every_single_hole_error_between_the_ends_of_block_is_found(text in tape(), eia: bool) {
        let code = if eia { Code::Eia } else { Code::Iso };
        let good = rows(&text, code);
        let end = code.end_of_block(EndOfBlock::Lf);
        let first = good.iter().position(|&row| row == end).expect("an end of block");
        let last = good.len() - 1;
        for row in first + 1..last {
            for track in 0..8 {
                let mut bad = good.clone();
                bad[row] ^= 1 << track;
                let found = decode(&bad, DecodeOptions { code: Some(code), ..DecodeOptions::default() });
                prop_assert!(found.issues.iter().any(|issue| issue.row == row), "row {row} track {}", track + 1);
            }
        }
    }

    #[test]
    fn a_lost_first_or_last_end_of_block_is_reported_as_missing(text in tape(), eia: bool, track in 0u8..8) {
        let code = if eia { Code::Eia } else { Code::Iso };
        let good = rows(&text, code);
        let end = code.end_of_block(EndOfBlock::Lf);
        let first = good.iter().position(|&row| row == end).expect("an end of block");
        // A comment may stand before the first end of block and behind the last: beside a block without a word the
        // next end of block is as good.
        let has_word = |line: &str| line.split(')').any(|part| !part.split('(').next().unwrap_or("").trim().is_empty());
        let blocks: Vec<&str> = text.lines().skip(1).collect();
        prop_assume!(has_word(blocks[0]) && has_word(blocks[blocks.len() - 1]));
        for (row, kind) in [(first, RowIssueKind::NoFirstEnd), (good.len() - 1, RowIssueKind::NoLastEnd)] {
            for bad in [end ^ (1 << track), 0x00] {
                let mut rows = good.clone();
                rows[row] = bad;
                let found = decode(&rows, DecodeOptions { code: Some(code), ..DecodeOptions::default() });
                prop_assert!(found.issues.iter().any(|issue| issue.kind == kind), "{:?} {}", found.issues, found.text);
            }
        }
    }

    #[test]
    fn any_rows_decode_to_a_text_with_issues_inside_it(rows in prop::collection::vec(any::<u8>(), 0..200), count_blocks: bool) {
        let decoded = decode(&rows, DecodeOptions { code: None, count_blocks });
        for issue in &decoded.issues {
            prop_assert!(issue.row < rows.len() && rows[issue.row] == issue.byte);
            prop_assert!(decoded.text.get(issue.range.clone()).is_some());
        }
    }
}
