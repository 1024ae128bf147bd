//! The codes in words: what each track counts, and what one row says in either code.

use super::Code;

/// One row under one code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowWords {
    /// One or a few characters to set beside the row; empty where it has no meaning.
    pub label: String,
    /// What the character is; `None` where the code has no such row.
    pub name: Option<&'static str>,
    /// The number of holes has the parity of the code.
    pub parity: bool,
    /// The weights of the holes, the parity and the character, in one or two sentences.
    pub sentence: String,
}

impl Code {
    /// What a hole counts or does in each track, track 1 first.
    pub fn tracks(self) -> [&'static str; 8] {
        match self {
            Code::Iso => ["1", "2", "4", "8", "16", "32", "64", "parity"],
            Code::Eia => ["1", "2", "4", "8", "parity", "zone", "zone", "end of block"],
        }
    }

    /// How the code is made, in sentences for someone who sees a tape for the first time.
    pub fn about(self) -> [&'static str; 3] {
        match self {
            Code::Iso => [
                "Tracks 1 to 7 count 1, 2, 4 and so on to 64: added up they are the number of the character, the same \
                 as in ASCII.",
                "Track 8 is the parity: it is punched wherever the other holes are odd in number, so that every row \
                 has an even number. One hole lost or torn, and the row is odd: the control stops.",
                "The end of a block is the line feed, tracks 2 and 4.",
            ],
            Code::Eia => [
                "Tracks 1 to 4 count 1, 2, 4 and 8: the digit. Tracks 6 and 7 are the zone, which makes letters of \
                 digits: both for A to I, 7 alone for J to R, 6 alone for S to Z.",
                "Track 5 is the parity: every row but blank tape has an odd number of holes.",
                "Track 8 alone is the end of a block, and nothing else has that track.",
            ],
        }
    }

    /// What a row says in this code, in words.
    pub fn row_words(self, row: u8) -> RowWords {
        let (label, name) = match self.meaning(row) {
            Some((label, name)) => (label, Some(name)),
            None => (String::new(), None),
        };
        // Blank tape is as it should be in both codes, although none is no odd number.
        let parity = self.parity_fits(row) || (row == 0 && name.is_some());
        let sentence = self.sentence(row, &label, name, parity);
        RowWords { label, name, parity, sentence }
    }

    fn sentence(self, row: u8, label: &str, name: Option<&str>, parity: bool) -> String {
        let holes = row.count_ones();
        if holes == 0 {
            return "No hole: blank tape.".to_owned();
        }
        let called = match name {
            Some(name) if label.chars().count() == 1 => format!("{label}, {name}"),
            Some(name) => name.to_owned(),
            None => "no character of this code".to_owned(),
        };
        let count = if holes == 1 { "1 hole".to_owned() } else { format!("{holes} holes") };
        let (is, wanted) = if holes.is_multiple_of(2) { ("even", "odd") } else { ("odd", "even") };
        let verdict = if parity {
            format!("{count}: {is}, as it must be.")
        } else {
            format!("{count}: {is}, and every row of this code is {wanted}.")
        };
        match self.sum(row) {
            Some(sum) if parity => format!("{sum}: {called}. {verdict}"),
            _ if parity => format!("{}. {verdict}", capital(&called)),
            _ => format!("{}. {verdict}", capital("no character of this code")),
        }
    }

    /// "64 + 4 + 2 + 1 = 71"; `None` where no hole counts.
    fn sum(self, row: u8) -> Option<String> {
        let weights: Vec<u32> = (0..8)
            .rev()
            .filter(|track| row & (1 << track) != 0)
            .filter_map(|track| self.tracks()[track].parse().ok())
            .collect();
        let total: u32 = weights.iter().sum();
        let terms: Vec<String> = weights.iter().map(u32::to_string).collect();
        match terms.as_slice() {
            [] => None,
            [one] => Some(one.clone()),
            _ => Some(format!("{} = {total}", terms.join(" + "))),
        }
    }
}

/// What both codes have in common.
pub fn about_tape() -> [&'static str; 2] {
    [
        "The tape is an inch wide and has eight tracks, a tenth of an inch apart; between tracks 3 and 4 run the small \
         feed holes that move it. A row across it is one character.",
        "No row is a character of both codes, because of the parity: that is how a control tells them apart.",
    ]
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_explained_under_both_codes() {
        let iso = Code::Iso.row_words(0x47);
        assert_eq!((iso.label.as_str(), iso.name, iso.parity), ("G", Some("letter"), true));
        assert_eq!(iso.sentence, "64 + 4 + 2 + 1 = 71: G, letter. 4 holes: even, as it must be.");
        let eia = Code::Eia.row_words(0x47);
        assert_eq!((eia.name, eia.parity), (None, false));
        assert_eq!(eia.sentence, "No character of this code. 4 holes: even, and every row of this code is odd.");
        assert_eq!(Code::Eia.row_words(0x67).sentence, "4 + 2 + 1 = 7: G, letter. 5 holes: odd, as it must be.");
        assert_eq!(Code::Eia.row_words(0x80).sentence, "End of block. 1 hole: odd, as it must be.");
        assert_eq!(
            Code::Iso.row_words(0x80).sentence,
            "No character of this code. 1 hole: odd, and every row of this code is even."
        );
    }

    #[test]
    fn blank_tape_is_right_in_both_codes() {
        for code in [Code::Iso, Code::Eia] {
            let blank = code.row_words(0);
            assert!(blank.parity);
            assert_eq!(blank.sentence, "No hole: blank tape.");
        }
    }

    #[test]
    fn the_weights_of_an_iso_row_add_up_to_its_character() {
        for row in 1..=u8::MAX {
            let Some(character) = Code::Iso.character(row) else { continue };
            let sum = Code::Iso.sum(row).expect("a hole that counts");
            let total = sum.rsplit(' ').next().and_then(|total| total.parse().ok());
            assert_eq!(total, Some(u32::from(character)), "{row:02X}");
        }
    }
}
