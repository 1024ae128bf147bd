//! Numbers and comments as LinuxCNC reads them.

use std::fmt::Write;

/// LinuxCNC reads lines of up to 255 characters; a comment is cut well before that, at a blank where there is one.
const LONGEST_COMMENT: usize = 180;

/// A number without exponent and without trailing zeros, to nine significant digits: more than any F or S word of a tape
/// can say, and enough that the time of a block agrees to a millionth.
pub(super) fn plain(value: f64) -> String {
    let mut before_point = 1;
    let mut limit = 10.0;
    while before_point < 9 && value.abs() >= limit {
        before_point += 1;
        limit *= 10.0;
    }
    let mut places = 9 - before_point;
    let mut limit = 1.0;
    while places < 15 && value != 0.0 && value.abs() < limit {
        places += 1;
        limit /= 10.0;
    }
    trimmed(format!("{value:.places$}"))
}

/// A length that is no whole number of increments: to nine decimal places, a millionth of any increment.
pub(super) fn offset(value: f64) -> String {
    trimmed(format!("{value:.9}"))
}

fn trimmed(mut text: String) -> String {
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".to_owned() } else { text }
}

/// A coordinate with the places of its least input increment.
pub(super) fn coordinate(value: f64, decimals: u8) -> String {
    // Zero has no sign.
    format!("{:.*}", usize::from(decimals), value + 0.0)
}

/// Comments of one line each that LinuxCNC passes over, whatever the text.
///
/// It knows no parentheses inside a comment, and takes some that begin with a word and a comma for orders to itself:
/// `(MSG,…)`, `(PROBEOPEN …)`.
pub(crate) fn comment_lines(text: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in text.split(|c: char| c.is_whitespace() || c.is_control()).filter(|word| !word.is_empty()) {
        let mut word: String = word.chars().map(harmless).collect();
        while line.len() + word.len() + 1 > LONGEST_COMMENT {
            if line.is_empty() {
                let cut = (0..=LONGEST_COMMENT - 1).rev().find(|&at| word.is_char_boundary(at)).unwrap_or(0);
                let rest = word.split_off(cut);
                lines.push(std::mem::replace(&mut word, rest));
            } else {
                lines.push(std::mem::take(&mut line));
            }
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(&word);
    }
    if !line.is_empty() {
        lines.push(line);
    }
    for line in &mut lines {
        let mark = if is_order(line) { "tape: " } else { "" };
        *line = format!("({mark}{line})");
    }
    lines
}

fn harmless(character: char) -> char {
    match character {
        '(' => '[',
        ')' => ']',
        other => other,
    }
}

/// LinuxCNC or its screens may take the comment for an order.
fn is_order(text: &str) -> bool {
    let letters = text.chars().take_while(|c| c.is_ascii_alphabetic() || *c == '_').count();
    let (word, rest) = text.split_at(letters);
    let rest = rest.trim_start();
    let order =
        ["logopen", "logappend", "logclose", "probeopen", "probeclose", "log", "print", "debug", "msg", "abort"];
    letters > 0 && (rest.starts_with(',') || order.iter().any(|order| word.eq_ignore_ascii_case(order)))
}

/// Words that may share a line: no two of one group, as LinuxCNC demands.
#[derive(Default)]
pub(super) struct Lines {
    pub lines: Vec<String>,
    groups: u32,
}

impl Lines {
    /// Adds words of a group, a number below 32, on a new line where the group has its word already.
    pub(super) fn add(&mut self, group: u32, words: &str) {
        let used = self.groups & (1 << group) != 0;
        match self.lines.last_mut() {
            Some(line) if !used => {
                let _ = write!(line, " {words}");
            }
            Some(line) if line.split(' ').any(|word| word == words) => {}
            _ => {
                self.lines.push(words.to_owned());
                self.groups = 0;
            }
        }
        self.groups |= 1 << group;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_no_exponent_and_no_needless_zeros() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (300.0, "300"),
            (0.5, "0.5"),
            (1.0 / 3.0, "0.333333333"),
            (2.0 / 3000.0, "0.000666666667"),
            (123_456.789, "123456.789"),
            (1e12, "1000000000000"),
            (9.999_999_999, "10"),
        ] {
            assert_eq!(plain(value), text);
        }
        assert_eq!(offset(-1e-12), "0");
        assert_eq!(offset(9.999_999_999_9), "10");
        assert_eq!(coordinate(-0.0, 3), "0.000");
        assert_eq!(coordinate(-1.5, 2), "-1.50");
    }

    #[test]
    fn a_comment_of_the_tape_gives_no_order() {
        assert_eq!(comment_lines("ROUGH (1\nof 2)"), ["(ROUGH [1 of 2])"]);
        assert_eq!(comment_lines(" msg , stop"), ["(tape: msg , stop)"]);
        assert_eq!(comment_lines("PROBECLOSE"), ["(tape: PROBECLOSE)"]);
        assert_eq!(comment_lines("ROUGH, THEN FINE"), ["(tape: ROUGH, THEN FINE)"], "any word may become an order");
        assert_eq!(comment_lines("R1, R2"), ["(R1, R2)"]);
        assert_eq!(comment_lines(" \n "), [""; 0]);
    }

    #[test]
    fn a_long_comment_is_cut_into_lines() {
        let lines = comment_lines(&"\u{E9}".repeat(1000));
        assert!(lines.iter().all(|line| line.len() < 200), "{lines:?}");
        assert_eq!(lines.concat().chars().filter(|c| *c == '\u{E9}').count(), 1000);
        assert_eq!(comment_lines(&"word ".repeat(100)).len(), 3);
    }

    #[test]
    fn words_of_one_group_stand_on_lines_of_their_own() {
        let mut lines = Lines::default();
        for (group, words) in [(7, "M3"), (8, "M8"), (8, "M8"), (8, "M7"), (7, "M4")] {
            lines.add(group, words);
        }
        assert_eq!(lines.lines, ["M3 M8", "M7 M4"]);
    }
}
