//! CTRL-06: a comment holds what looks like blocks.

use crate::read::StrayKind;
use crate::rules::prelude::*;
use crate::text::{Listing, Mark};
use std::ops::Range;

/// The rule.
pub static RULE: Rule = Rule {
    name: "blocks-in-comment",
    title: "A comment holds what looks like blocks.",
    verdicts: Verdicts::all("CTRL-06", Severity::Warning),
    clauses: &[Clause::Iso2539("B.2 note 4"), Clause::Iso1058("B.2 note 6")],
    page: page!("CTRL-06"),
};

pub(crate) fn check(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    for Swallowed { at, end, count, joined } in found(block) {
        let what = if count == 1 {
            "what looks like a block".to_owned()
        } else {
            format!("{count} lines that look like blocks")
        };
        let message = if joined {
            "The comment that begins here runs over a line end and ends in the comment of the next block, which the \
             control reads as part of this one. Close the comment at the end of its line."
                .to_owned()
        } else {
            format!(
                "The comment that begins here runs over {what}, which the control ignores. If they are to be executed, \
                 close the comment before them."
            )
        };
        sink.report(&RULE, at..at + 1, message)
            .count(count)
            .fix(|| Fix::replace("Close it at the end of the line", end..end, ")"));
    }
}

/// Where the comments stand that are reported, in order.
pub(super) fn places(block: &BlockView<'_>) -> Vec<Range<usize>> {
    let behind = |at: usize| block.text[at..].find(')').map_or(block.text.len(), |length| at + length);
    found(block).into_iter().map(|found| found.at..behind(found.at)).collect()
}

/// A comment of the block runs over a line end and joins the block behind it to this one.
pub(crate) fn joins(block: &BlockView<'_>) -> bool {
    found(block).iter().any(|found| found.joined)
}

/// A comment that goes on behind a line end and holds what looks like blocks.
struct Swallowed {
    /// Its `(`.
    at: usize,
    /// Its first line end.
    end: usize,
    /// How many blocks.
    count: usize,
    /// The last one is read: it begins with the comment that ends this one.
    joined: bool,
}

fn found(block: &BlockView<'_>) -> Vec<Swallowed> {
    // A comment that nothing closes is said to be one: CTRL-01.
    if !block.comment || block.strays.iter().any(|stray| stray.kind == StrayKind::Unclosed) {
        return Vec::new();
    }
    let mut found: Vec<Swallowed> = Vec::new();
    let mut open = 0;
    for character in Listing::new(block.text) {
        match character.mark {
            Mark::Character('(') if !character.comment => open = character.from,
            Mark::EndOfBlock if character.comment => {
                let behind = &block.text[character.to..];
                let commented = behind_comment(behind);
                if !begins_block(commented.unwrap_or(behind)) {
                    continue;
                }
                let joined = commented.is_some();
                match found.last_mut() {
                    Some(last) if last.at == open => {
                        last.count += 1;
                        last.joined |= joined;
                    }
                    _ => found.push(Swallowed { at: open, end: first_line_end(block.text, open), count: 1, joined }),
                }
            }
            _ => {}
        }
    }
    found
}

fn first_line_end(text: &str, open: usize) -> usize {
    text[open..].find(['\n', '\r', '*']).map_or(text.len(), |at| open + at)
}

/// What follows a comment that heads a line, on that line.
fn behind_comment(text: &str) -> Option<&str> {
    let comment = text.trim_start_matches(' ').strip_prefix('(')?;
    let end = comment.find([')', '\n', '\r', '*'])?;
    comment[end..].strip_prefix(')')
}

/// The text begins with a sequence number word and another word behind it.
fn begins_block(text: &str) -> bool {
    let line = text.split(['\n', '\r', '*', ')']).next().unwrap_or("").trim_start().trim_start_matches('/');
    let Some(number) = line.strip_prefix(['N', 'n', ':']) else { return false };
    let rest = number.trim_start_matches(|digit: char| digit.is_ascii_digit());
    let mut word = rest.trim_start().chars();
    let address = word.next().is_some_and(|letter| letter.is_ascii_alphabetic());
    rest.len() < number.len() && address && word.next().is_some_and(|c| c.is_ascii_digit() || matches!(c, '+' | '-'))
}
