//! Comments as they are carried over.

use crate::text::Listing;
use std::ops::Range;

/// The comments of a stretch that begins outside one, without their parentheses.
pub(super) fn comments(text: &str, stretch: Range<usize>) -> Vec<String> {
    let mut comments: Vec<String> = Vec::new();
    if !text[stretch.clone()].contains('(') {
        return comments;
    }
    let mut open = false;
    for character in Listing::resume(text, stretch.start, false).take_while(|it| it.from < stretch.end) {
        if character.comment {
            if !std::mem::replace(&mut open, true) {
                comments.push(String::new());
            }
            let written = &text[character.from..character.to];
            comments.iter_mut().last().into_iter().for_each(|comment| comment.push_str(written));
        } else {
            open = false;
        }
    }
    comments
}
