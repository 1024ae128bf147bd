//! The vocabulary: words, their codes, and the dialects that differ on some of them.

use super::word_table::CODES;
use crate::format::choices;

choices! {
    /// Whose table of codes a file with integer-coded commands (type 2000) follows, where tables differ.
    Dialect {
        /// What most tables have.
        Common = "common", "what most systems have";
        /// APT360, 1969.
        Apt360 = "apt360", "APT360";
        /// APT4 SSV3, 1989.
        Ssv3 = "ssv3", "APT4 SSV3";
        /// PostWorks.
        PostWorks = "postworks", "PostWorks";
        /// NCL.
        Ncl = "ncl", "NCL";
        /// IBM's APT and CATIA.
        Ibm = "ibm", "IBM APT and CATIA";
    }
}

/// Where a word may stand: first in a command, or behind that.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// A major word: the command.
    Major,
    /// A minor word: what modifies it.
    Minor,
}

/// One code: where its word may stand, the code, the word, and the tables that have it so.
pub(super) struct Code(pub Part, pub u16, pub &'static str, pub u8);

pub(super) const APT360: u8 = 1;
pub(super) const SSV3: u8 = 2;
pub(super) const POSTWORKS: u8 = 4;
pub(super) const NCL: u8 = 8;
pub(super) const IBM: u8 = 16;
/// Most tables have it so.
pub(super) const COMMON: u8 = 32;

impl Dialect {
    fn bit(self) -> u8 {
        match self {
            Dialect::Common => COMMON,
            Dialect::Apt360 => APT360,
            Dialect::Ssv3 => SSV3,
            Dialect::PostWorks => POSTWORKS,
            Dialect::Ncl => NCL,
            Dialect::Ibm => IBM,
        }
    }
}

/// A word of up to eight letters in one number, so that words are compared at once; zero for any other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Key(pub(super) u64);

impl Key {
    /// The key of a word in capital letters.
    pub const fn of(word: &str) -> Key {
        Key::of_bytes(word.as_bytes())
    }

    pub(super) const fn of_bytes(word: &[u8]) -> Key {
        if word.len() > 8 {
            return Key(0);
        }
        let (mut key, mut index) = (0, 0);
        while index < word.len() {
            key = key << 8 | word[index] as u64;
            index += 1;
        }
        Key(key)
    }

    /// The word.
    pub fn word(self) -> String {
        self.0.to_be_bytes().into_iter().filter(|byte| *byte != 0).map(char::from).collect()
    }
}

/// The words as a set, to tell at once whether one is known.
pub(super) struct Vocabulary {
    slots: Vec<Key>,
}

/// A power of two of at least twice as many slots as there are words, so that a search ends soon.
const SLOTS: usize = 1024;

impl Vocabulary {
    pub(super) fn new() -> Vocabulary {
        let mut vocabulary = Vocabulary { slots: vec![Key(0); SLOTS] };
        for Code(_, _, word, _) in CODES {
            let key = Key::of(word);
            let slot = vocabulary.slot(key);
            vocabulary.slots[slot] = key;
        }
        vocabulary
    }

    pub(super) fn knows(&self, key: Key) -> bool {
        key != Key(0) && self.slots[self.slot(key)] == key
    }

    /// Where the key is, or where it would be.
    fn slot(&self, key: Key) -> usize {
        // The multiplier is 2^64 over the golden ratio: it spreads keys that differ in few bits.
        let mut slot = (key.0.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 54) as usize;
        while self.slots[slot] != Key(0) && self.slots[slot] != key {
            slot = (slot + 1) % SLOTS;
        }
        slot
    }
}

/// What the tables make of a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coded {
    /// The word in the dialect.
    pub word: Key,
    /// Another word that a table has for the code.
    pub other: Option<Key>,
}

/// The word of an integer code in a dialect: its own where it has one, otherwise what most tables have, otherwise what
/// any has.
pub fn decode(part: Part, code: u16, dialect: Dialect) -> Option<Coded> {
    let from = CODES.partition_point(|row| (row.0, row.1) < (part, code));
    let rows: Vec<&Code> = CODES[from..].iter().take_while(|row| (row.0, row.1) == (part, code) && code > 0).collect();
    let in_table = |bit: u8| rows.iter().find(|row| row.3 & bit != 0);
    let preferred = in_table(COMMON).filter(|row| row.3 & dialect.bit() != 0);
    let row = preferred.or(in_table(dialect.bit())).or(in_table(COMMON)).or(rows.first())?;
    let other = rows.iter().find(|other| other.2 != row.2).map(|other| Key::of(other.2));
    Some(Coded { word: Key::of(row.2), other })
}

/// The known word that is nearest to one that is not: at most one letter in three differs.
pub fn nearest(word: &str) -> Option<&'static str> {
    let letters = |row: &&Code| row.2.bytes().all(|byte| byte.is_ascii_uppercase());
    let near = CODES.iter().filter(letters).map(|row| (distance(word.as_bytes(), row.2.as_bytes()), row.2));
    near.min_by_key(|(distance, _)| *distance).filter(|(distance, near)| 3 * distance <= near.len()).map(|near| near.1)
}

/// How many letters are to be put in, left out, changed or swapped with the next, to make one word of the other.
fn distance(from: &[u8], to: &[u8]) -> usize {
    // No word is longer than eight letters: far longer ones are not near.
    if from.len() > 16 {
        return usize::MAX / 3;
    }
    let width = to.len() + 1;
    let mut table = vec![0; (from.len() + 1) * width];
    for row in 0..=from.len() {
        for column in 0..=to.len() {
            let at = |up: usize, left: usize| (row - up) * width + column - left;
            table[row * width + column] = if row == 0 || column == 0 {
                row + column
            } else {
                let same = from[row - 1] == to[column - 1];
                let mut best = (table[at(1, 1)] + usize::from(!same)).min(table[at(1, 0)] + 1).min(table[at(0, 1)] + 1);
                let swapped =
                    row > 1 && column > 1 && from[row - 1] == to[column - 2] && from[row - 2] == to[column - 1];
                if swapped {
                    best = best.min(table[at(2, 2)] + 1);
                }
                best
            };
        }
    }
    table[from.len() * width + to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_order_and_its_words_have_keys() {
        assert!(CODES.is_sorted_by_key(|row| (row.0, row.1, row.2)));
        let vocabulary = Vocabulary::new();
        for Code(_, _, word, _) in CODES {
            assert_eq!(Key::of(word).word(), *word);
            assert!(vocabulary.knows(Key::of(word)), "{word}");
        }
        assert!(!vocabulary.knows(Key::of("FEDRATE")) && !vocabulary.knows(Key(0)));
    }

    #[test]
    fn codes_on_which_the_tables_agree_and_differ() {
        let word = |part, code, dialect| decode(part, code, dialect).map(|coded| coded.word.word());
        // 5.14.2 of ISO 3592 prints 1045 as PARTNO's.
        assert_eq!(word(Part::Major, 1045, Dialect::Common).as_deref(), Some("PARTNO"));
        assert_eq!(word(Part::Minor, 60, Dialect::Common).as_deref(), Some("CLW"));
        assert_eq!(word(Part::Major, 17, Dialect::Common).as_deref(), Some("GOHOME"));
        assert_eq!(word(Part::Major, 14, Dialect::Apt360).as_deref(), Some("GOHOME"));
        assert_eq!(word(Part::Major, 17, Dialect::Apt360).as_deref(), Some("DRAWLI"));
        assert_eq!(word(Part::Minor, 9999, Dialect::Common), None);
        assert_eq!(word(Part::Minor, 0, Dialect::Common), None);
    }

    #[test]
    fn the_nearest_word() {
        for (word, near) in
            [("FEDRATE", Some("FEDRAT")), ("SPINDEL", Some("SPINDL")), ("RAPDI", Some("RAPID")), ("QQQQQ", None)]
        {
            assert_eq!(nearest(word), near, "{word}");
        }
    }
}
