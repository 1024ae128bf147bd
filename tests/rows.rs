//! The pages of the family ROW: their examples are rows of holes, in hexadecimal, and hang on no format.
//!
//! ` ```rows bad iso ` must give the rule at the row in brackets and nothing else; ` ```rows good iso ` must not give it.
//! `count` behind the code asks for the vertical check.

use nctape::code::{Code, DecodeOptions, decode};
use nctape::rules::{ALL, Rule};

struct Example {
    bad: bool,
    options: DecodeOptions,
    rows: Vec<u8>,
    marked: Option<usize>,
}

fn examples(rule: &Rule) -> Vec<Example> {
    let mut examples = Vec::new();
    let mut rest = rule.page;
    while let Some(at) = rest.find("```rows ") {
        let (head, body) = rest[at + 8..].split_once('\n').expect("a fence");
        let (hex, behind) = body.split_once("\n```").expect("the end of the fence");
        let words: Vec<&str> = head.split(' ').collect();
        let code = if words[1] == "iso" { Code::Iso } else { Code::Eia };
        let bytes: Vec<&str> = hex.split_whitespace().collect();
        examples.push(Example {
            bad: words[0] == "bad",
            options: DecodeOptions { code: Some(code), count_blocks: words.contains(&"count") },
            rows: bytes
                .iter()
                .map(|byte| u8::from_str_radix(byte.trim_matches(['[', ']']), 16).expect("a row"))
                .collect(),
            marked: bytes.iter().position(|byte| byte.starts_with('[')),
        });
        rest = behind;
    }
    examples
}

#[test]
fn every_page_shows_its_rule() {
    let rules: Vec<&&Rule> = ALL.iter().filter(|rule| rule.family() == "ROW").collect();
    assert!(!rules.is_empty());
    for rule in rules {
        assert!(rule.page.starts_with(&format!("# {} {}\n", rule.id(), rule.name)), "{}", rule.id());
        let examples = examples(rule);
        assert!(examples.iter().any(|example| example.bad) && examples.iter().any(|example| !example.bad));
        for example in examples {
            let found = decode(&example.rows, example.options).issues;
            let rows: Vec<(&str, usize)> = found.iter().map(|issue| (issue.kind.rule().id(), issue.row)).collect();
            let expected: Vec<(&str, usize)> = example.marked.map(|row| (rule.id(), row)).into_iter().collect();
            assert_eq!(rows, expected, "{} {:02X?}", rule.id(), example.rows);
            assert_eq!(example.bad, example.marked.is_some(), "{}", rule.id());
        }
    }
}

/// Where a code is recognised by itself, it is the one that the example is in.
#[test]
fn good_examples_are_recognised() {
    for example in ALL.iter().filter(|rule| rule.family() == "ROW").flat_map(|rule| examples(rule)) {
        if !example.bad {
            assert_eq!(Some(decode(&example.rows, DecodeOptions::default()).code), example.options.code);
        }
    }
}
