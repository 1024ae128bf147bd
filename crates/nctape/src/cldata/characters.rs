//! The characters of the reference language (5.2 to 5.6), and those that editors put in their place.

/// A format character: horizontal tabulator, line feed, form feed, carriage return, space. It has no significance
/// outside of literals (5.4.1).
pub(super) const fn is_layout(byte: u8) -> bool {
    matches!(byte, 9 | 10 | 12 | 13 | 32)
}

/// What a typographic character was before an editor or a printed page changed it.
pub(super) fn plain(character: char) -> Option<char> {
    match character {
        // Single quotation marks, the modifier apostrophe, the full-width apostrophe.
        '\u{2018}' | '\u{2019}' | '\u{201B}' | '\u{02BC}' | '\u{FF07}' => Some('\''),
        // Hyphens and dashes, the minus sign, the full-width hyphen.
        '\u{2010}'..='\u{2015}' | '\u{2212}' | '\u{FF0D}' => Some('-'),
        // The blanks that do not break, and the byte order mark.
        '\u{00A0}' | '\u{2007}' | '\u{202F}' | '\u{FEFF}' => Some(' '),
        _ => None,
    }
}

/// An apostrophe, or a typographic one.
pub(super) fn is_quote(character: char) -> bool {
    character == '\'' || plain(character) == Some('\'')
}
