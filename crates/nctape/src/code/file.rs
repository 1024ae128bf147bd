//! What a file holds: a listing, or the image of a tape.

use super::{DecodeOptions, Decoded, decode};

/// A file that was opened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Opened {
    /// Text that a person could read.
    Listing {
        /// The text, in Unicode.
        text: String,
        /// Why it was taken for a listing.
        reason: String,
    },
    /// One byte for each row of a tape.
    Image {
        /// What the rows say.
        decoded: Decoded,
        /// Why it was taken for an image of a tape.
        reason: String,
    },
}

/// So many bytes in a hundred may be beyond ASCII in a listing that is not Unicode: a comment in another language.
/// In a tape in ISO code track 8 is punched in some half of the rows.
const FOREIGN_IN_100: usize = 5;

/// Reads a file by what is in it; its name decides nothing.
///
/// ```
/// use nctape::code::{Opened, open};
/// assert!(matches!(open(b"%\nN001 G01\n"), Opened::Listing { .. }));
/// assert!(matches!(open(&[0x00, 0x80, 0x45, 0x20, 0x20, 0x01, 0x80]), Opened::Image { .. }));
/// ```
pub fn open(bytes: &[u8]) -> Opened {
    if let Some(listing) = unicode(bytes) {
        return listing;
    }
    // Blank tape and delete around plain characters: an image punched without parity, which is a listing all the same.
    let kept: Vec<u8> = bytes.iter().copied().filter(|byte| !matches!(byte, 0x00 | 0x7F)).collect();
    if kept.len() < bytes.len() && kept.contains(&b'\n') && kept.iter().all(|&byte| is_plain(byte)) {
        let reason = "Plain ASCII with blank tape or deletes around it: the image of a tape punched without parity. It \
                      is read as a listing.";
        return Opened::Listing { text: kept.into_iter().map(char::from).collect(), reason: reason.to_owned() };
    }
    let foreign = bytes.iter().filter(|&&byte| byte >= 0xA0).count();
    let readable = bytes.iter().all(|&byte| is_plain(byte) || byte >= 0xA0);
    if readable && foreign * 100 <= bytes.len() * FOREIGN_IN_100 {
        let reason = "Text of one byte a character. What is beyond ASCII is read as ISO 8859-1.";
        return Opened::Listing { text: bytes.iter().copied().map(char::from).collect(), reason: reason.to_owned() };
    }
    let decoded = decode(bytes, DecodeOptions::default());
    Opened::Image { decoded, reason: "Not text: the image of a tape, one byte for each row.".to_owned() }
}

/// Text in UTF-8, or in UTF-16 with its mark in front.
fn unicode(bytes: &[u8]) -> Option<Opened> {
    let wide = |units: &dyn Fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|pair| units([pair[0], pair[1]])).collect();
        let text = String::from_utf16_lossy(&units);
        Opened::Listing { text, reason: "Text in UTF-16, by the mark in front of it.".to_owned() }
    };
    match bytes {
        [0xFF, 0xFE, ..] => return Some(wide(&u16::from_le_bytes)),
        [0xFE, 0xFF, ..] => return Some(wide(&u16::from_be_bytes)),
        _ => {}
    }
    // Ctrl+Z ended a text file for CP/M and DOS.
    let until = bytes.iter().rposition(|&byte| byte != 0x1A).map_or(0, |last| last + 1);
    let text = std::str::from_utf8(&bytes[..until]).ok()?;
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(text);
    let readable =
        text.chars().all(|character| !character.is_control() || matches!(character, '\t' | '\n' | '\r' | '\u{C}'));
    readable.then(|| Opened::Listing { text: text.to_owned(), reason: "Text.".to_owned() })
}

fn is_plain(byte: u8) -> bool {
    matches!(byte, b'\t' | b'\n' | b'\r' | 0x0C | 0x1A | 0x20..=0x7E)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::code::lettering::lettering;
    use crate::code::{Code, EndOfBlock, RowIssueKind, encode};

    const TAPE: &str = "%\nN001G01X+001000F0300\nN002M30\n";

    fn listing(bytes: &[u8]) -> String {
        match open(bytes) {
            Opened::Listing { text, .. } => text,
            Opened::Image { decoded, .. } => panic!("an image: {decoded:?}"),
        }
    }

    fn image(bytes: &[u8]) -> Decoded {
        match open(bytes) {
            Opened::Listing { text, .. } => panic!("a listing: {text}"),
            Opened::Image { decoded, .. } => decoded,
        }
    }

    #[test]
    fn text_is_a_listing_whatever_its_line_ends() {
        for text in ["", TAPE, "N001\tG01\r\nN002\r\n", "(\u{e9}t\u{e9}) N1*\n"] {
            assert_eq!(listing(text.as_bytes()), text);
        }
        assert_eq!(listing(b"\xEF\xBB\xBFN001\n"), "N001\n");
        assert_eq!(listing(b"N001\n\x1A\x1A"), "N001\n");
        assert_eq!(listing(b"\xFF\xFEN\x001\x00\n\x00"), "N1\n");
        assert_eq!(listing(b"\xFE\xFF\x00N\x001\x00\n"), "N1\n");
        let latin = [b"(pi\xE8ce)\n", TAPE.as_bytes()].concat();
        assert!(listing(&latin).contains('\u{e8}'));
    }

    #[test]
    fn an_image_without_parity_is_a_listing() {
        let mut bytes = vec![0; 30];
        bytes.extend(TAPE.as_bytes());
        bytes.extend([0x7F, 0x7F, 0, 0]);
        assert_eq!(listing(&bytes), TAPE);
    }

    #[test]
    fn rows_of_either_code_are_an_image() {
        for code in [Code::Iso, Code::Eia] {
            let decoded = image(&encode(TAPE, code, EndOfBlock::Lf).bytes);
            assert_eq!((decoded.code, decoded.text.as_str(), decoded.by_return), (code, TAPE, false));
        }
        let decoded = image(&encode(TAPE, Code::Iso, EndOfBlock::Cr).bytes);
        assert_eq!((decoded.text.as_str(), decoded.by_return), (TAPE, true));
        // Track 8 in every row: the line feed is 8A, and what is beside the carriage return must still be seen.
        let marked: Vec<u8> = TAPE.replace('\n', "\r\n").bytes().map(|byte| byte | 0x80).collect();
        let decoded = image(&marked);
        assert_eq!((decoded.text.as_str(), decoded.by_return), (TAPE, false));
    }

    #[test]
    fn a_name_in_the_leader_is_passed_over_as_a_label() {
        // Long names before a short program: what the letters count for must not decide the code.
        for name in [
            "ADA",
            "GRACE HOPPER & FRIENDS",
            "I",
            "1",
            "0123456789-+.,'!?/:&",
            "THE QUICK BROWN FOX JUMPS OVER A LAZY DOG",
        ] {
            for code in [Code::Iso, Code::Eia] {
                let mut bytes = lettering(name);
                bytes.extend(encode(TAPE, code, EndOfBlock::Lf).bytes);
                let decoded = decode(&bytes, DecodeOptions::default());
                assert_eq!((decoded.code, decoded.text.as_str()), (code, TAPE), "{name}");
                let labels = decoded.issues.iter().filter(|issue| issue.kind == RowIssueKind::Label).count();
                assert_eq!((decoded.issues.len(), labels), (1, 1), "{name}: {:?}", decoded.issues);
            }
        }
    }
}
