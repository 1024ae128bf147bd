//! The statements of CL text: lines, continued by `$`, with comments behind `$$`.

use std::ops::Range;

/// One statement, its lines joined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Statement {
    /// Where it stands in the text, from its first character to its last.
    pub range: Range<usize>,
    /// The number of the line on which it begins, from 1.
    pub line: usize,
    /// A comment that says something to whoever looks into comments: what stands behind `$$->`.
    pub is_aside: bool,
    /// Its characters, without continuation signs, comments and line ends.
    pub joined: String,
}

/// The statements of a text in their order; comments that say nothing and empty lines are left out.
pub(super) fn statements(text: &str) -> Vec<Statement> {
    let mut found: Vec<Statement> = Vec::new();
    let mut continues = false;
    let mut in_comment = false;
    for (number, (start, line)) in lines(text).enumerate() {
        let trimmed = line.trim();
        if continues && in_comment && !is_aside_continued(&found) {
            continues = ends_in_continuation(trimmed);
            continue;
        }
        let begins = !continues;
        if begins && trimmed.starts_with("$$") {
            in_comment = true;
            continues = ends_in_continuation(&trimmed[2..]);
            let Some(aside) = trimmed.strip_prefix("$$->") else { continue };
            let joined = without_continuation(aside).to_owned();
            found.push(Statement { range: span(start, line), line: number + 1, is_aside: true, joined });
            continue;
        }
        if begins {
            in_comment = false;
        }
        let body = if in_comment { trimmed } else { trimmed.split("$$").next().unwrap_or("").trim_end() };
        let text_statement = begins && is_text(body);
        continues = !text_statement && ends_in_continuation(body);
        let body = if continues { without_continuation(body) } else { body };
        match found.last_mut().filter(|_| !begins) {
            Some(statement) => {
                statement.joined.push_str(body);
                statement.range.end = span(start, line).end.max(statement.range.end);
            }
            None if body.is_empty() => {}
            None => found.push(Statement {
                range: span(start, line),
                line: number + 1,
                is_aside: false,
                joined: body.to_owned(),
            }),
        }
    }
    found
}

/// Words behind which the rest of the line is text, as it stands.
const TEXT: [&str; 3] = ["PARTNO", "PPRINT", "INSERT"];

/// The word of a statement of text, and the text.
pub(super) fn text_of(joined: &str) -> Option<(&'static str, &str)> {
    let word = TEXT.into_iter().find(|word| {
        let rest =
            joined.get(..word.len()).filter(|head| head.eq_ignore_ascii_case(word)).map(|_| &joined[word.len()..]);
        rest.is_some_and(|rest| !rest.starts_with(|next: char| next.is_ascii_alphanumeric()))
    })?;
    let rest = joined[word.len()..].trim_start();
    Some((word, rest.strip_prefix('/').unwrap_or(rest).trim()))
}

fn is_text(body: &str) -> bool {
    text_of(body).is_some()
}

/// The comment that goes on is one that is looked into.
fn is_aside_continued(found: &[Statement]) -> bool {
    found.last().is_some_and(|statement| statement.is_aside)
}

fn ends_in_continuation(line: &str) -> bool {
    line.ends_with('$')
}

fn without_continuation(line: &str) -> &str {
    line.trim_end_matches('$').trim()
}

/// Where a line stands, without the blanks around it.
fn span(start: usize, line: &str) -> Range<usize> {
    let from = start + (line.len() - line.trim_start().len());
    from..from + line.trim().len()
}

/// Each line with the byte at which it begins; LF, CR LF and CR end one.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let rest = text.get(at..).filter(|rest| !rest.is_empty())?;
        let end = rest.find(['\n', '\r']).unwrap_or(rest.len());
        let line = (at, &rest[..end]);
        at += end + if rest[end..].starts_with("\r\n") { 2 } else { 1 };
        Some(line)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined(text: &str) -> Vec<(usize, String)> {
        statements(text).into_iter().map(|statement| (statement.line, statement.joined)).collect()
    }

    #[test]
    fn lines_are_joined_and_comments_left_out() {
        let text = "$$* made by hand $\nstill a comment\nGOTO / 1.0,$\n 2.0,  $$ a point\nFINI\n\nPPRINT costs 5 $\nRAPID\r\nSTOP";
        let found = joined(text);
        let expected = [(3, "GOTO / 1.0,2.0,"), (5, "FINI"), (7, "PPRINT costs 5 $"), (8, "RAPID"), (9, "STOP")];
        assert_eq!(found, expected.map(|(line, joined)| (line, joined.to_owned())));
        assert_eq!(&text[statements(text)[0].range.clone()], "GOTO / 1.0,$\n 2.0,  $$ a point");
    }

    #[test]
    fn an_aside_goes_on_over_lines_and_is_no_statement() {
        let found = statements("$$-> CSYS / 1.0, $\n 0.0, $\n 0.0\nRAPID\n");
        assert_eq!(found.len(), 2);
        assert!(found[0].is_aside && found[0].joined == "CSYS / 1.0,0.0,0.0", "{found:?}");
        assert_eq!((found[1].line, found[1].joined.as_str()), (4, "RAPID"));
    }

    #[test]
    fn text_behind_its_word_is_kept_as_it_is() {
        assert_eq!(text_of("PARTNO / MFG0004"), Some(("PARTNO", "MFG0004")));
        assert_eq!(text_of("PPRINT it's a $ sign"), Some(("PPRINT", "it's a $ sign")));
        assert_eq!(text_of("PARTNOX / 1"), None);
    }
}
