//! Letters for people where a control looks for none: the name of a part before the program, or behind its `%`.
//!
//! On the tape nothing tells such a label from words: it is taken for one where most of its letters have no digits.

/// Reads a label that may begin at a byte of the text. Tells where it ends, if it is one, and how far the text was looked
/// at.
///
/// It ends before the end of block or the comment behind it. Before the first program start it may have several lines,
/// and goes up to the `%` behind them.
pub(super) fn read(text: &str, from: usize, before_start: bool) -> (Option<usize>, usize) {
    let first = from + run(&text[from..]);
    if !is_prose(&text[from..first]) {
        return (None, first + 1);
    }
    if !before_start {
        return (Some(first), first + 1);
    }
    let mut at = first;
    loop {
        let rest = &text[at..];
        match rest.bytes().next() {
            Some(b'%') => return (Some(at), at + 1),
            Some(b'\n' | b'\r' | b'*' | b' ') => at += 1,
            Some(b'(') => match rest.find(')') {
                Some(comment) => at += comment + 1,
                None => return (Some(first), text.len() + 1),
            },
            None => return (Some(first), at + 1),
            Some(_) => {
                let end = at + run(rest);
                if !is_prose(&text[at..end]) {
                    return (Some(first), end + 1);
                }
                at = end;
            }
        }
    }
}

/// The bytes before the end of block, comment or program start.
fn run(text: &str) -> usize {
    text.find(['\n', '\r', '*', '(', '%']).unwrap_or(text.len())
}

/// Most letters are no addresses, for no digit follows. What begins with a sequence number is a block; a `)` is the end
/// of a comment, and a fault of its own.
fn is_prose(text: &str) -> bool {
    let mut characters = text.chars().filter(|&character| character != ' ').peekable();
    let (mut letters, mut addresses, mut heads) = (0, 0, true);
    while let Some(character) = characters.next() {
        let digit_follows = characters.peek().is_some_and(|next| next.is_ascii_digit() || matches!(next, '+' | '-'));
        match character {
            'N' | 'n' | ':' if heads && digit_follows => return false,
            'A'..='Z' | 'a'..='z' | ':' if digit_follows => addresses += 1,
            'A'..='Z' | 'a'..='z' | ':' => letters += 1,
            '0'..='9' | '+' | '-' | '.' | ',' | '/' | '\t' | '\0' | '\u{8}' | '\u{7F}' => {}
            ')' => return false,
            // No character of a word at all.
            _ => letters += 2,
        }
        heads &= character == '/';
    }
    letters > 1 && letters > addresses
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn a_label_is_told_from_a_block() {
        for label in ["PLATE 12", "12 HOLES", "PROG1", "FACE/SIDE", "\u{1F600}", "DATE 3-11-72"] {
            assert_eq!(read(label, 0, false).0, Some(label.len()), "{label}");
        }
        for block in
            ["N001 G X", "/N001 GX", "G00 X+001000", "GO1 X+001000 F0300", "O1234", "SETUP) N001", "12", ":1 AB"]
        {
            assert_eq!(read(block, 0, false).0, None, "{block}");
        }
    }

    #[test]
    fn before_the_program_start_a_label_has_several_lines() {
        let ends = |text| read(text, 0, true).0;
        assert_eq!(ends("PLATE\n\nSIDE (A\nB)\n%\nN001"), Some(18));
        assert_eq!(ends("PLATE\nSIDE\nN001 M30\n%\n"), Some(5), "a block stands between them");
        assert_eq!(ends("PLATE\nSIDE (A\n%\n"), Some(5), "a comment that nothing closes");
        assert_eq!(ends("PLATE"), Some(5));
    }
}
