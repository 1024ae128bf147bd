//! The tables of functions, entry by entry.
//!
//! `functions/iso1056.csv` holds all of G00 to G99 and M00 to M99 as the sources of ISO 1056:1975 have them: JB 3208-83
//! in its transcriptions, compared with the notes of GOST 20999-83, DIN 66025, a list of RS-274-D and a Heidenhain TNC
//! 155 manual. Groups of G are the letters of the table. `hold` and `start` are its columns of marks; `open` is its
//! mark #. Where the sources differ, what was taken has its reason beside the table in `src/function`.

use nctape::function::{
    Group, Hold, Matter, Miscellaneous, Preparatory, Start, miscellaneous, miscellaneous_conflict, preparatory,
    preparatory_conflict,
};

struct Entry {
    letter: char,
    code: u8,
    meaning: String,
    group: String,
    hold: String,
    start: String,
}

fn table() -> Vec<Entry> {
    let entry = |line: &str| {
        let (mut fields, mut quoted) = (vec![String::new()], false);
        for character in line.chars() {
            match character {
                '"' => quoted = !quoted,
                ',' if !quoted => fields.push(String::new()),
                _ => fields.last_mut().unwrap().push(character),
            }
        }
        let [name, meaning, group, hold, start] = fields.try_into().expect("five fields");
        let (letter, code) = name.split_at(1);
        let letter = letter.chars().next().unwrap();
        Entry { letter, code: code.parse().unwrap(), meaning, group, hold, start }
    };
    include_str!("functions/iso1056.csv").lines().skip(1).map(entry).collect()
}

fn hold(hold: Hold) -> &'static str {
    match hold {
        Hold::Stays => "stays",
        Hold::Block => "block",
        Hold::Open => "open",
    }
}

fn start(start: Start) -> &'static str {
    match start {
        Start::With => "with",
        Start::After => "after",
        Start::Open => "open",
    }
}

/// The matters of M by the words of the table.
fn matter(name: &str) -> Option<Matter> {
    let all = [
        ("stop", Matter::Stop),
        ("spindle", Matter::Spindle),
        ("coolant", Matter::Coolant),
        ("tool", Matter::Tool),
        ("clamp", Matter::Clamp),
        ("motion", Matter::Motion),
        ("interlock", Matter::Interlock),
        ("feed range", Matter::FeedRange),
        ("spindle range", Matter::SpeedRange),
        ("gear", Matter::Gear),
        ("override", Matter::Override),
        ("tool shift", Matter::ToolShift),
        ("workpiece", Matter::Workpiece),
        ("workpiece shift", Matter::WorkpieceShift),
    ];
    all.iter().find(|(word, _)| *word == name).map(|(_, matter)| *matter)
}

#[test]
fn every_entry_of_the_tables() {
    let table = table();
    for (letter, entries) in [('G', &table[..100]), ('M', &table[100..])] {
        assert_eq!(entries.len(), 100);
        for (code, entry) in entries.iter().enumerate() {
            assert_eq!((entry.letter, usize::from(entry.code)), (letter, code), "in order and complete");
            let Entry { meaning, group, hold: holds, start: starts, .. } = entry;
            let found = match letter {
                'G' => match preparatory(entry.code) {
                    Preparatory::Assigned(group, meaning) => {
                        (meaning, group.letter().to_owned(), hold(group.hold()), "")
                    }
                    Preparatory::Unassigned => ("unassigned", String::new(), "", ""),
                    Preparatory::PermanentlyUnassigned => ("permanently unassigned", String::new(), "", ""),
                },
                _ => match miscellaneous(entry.code) {
                    Miscellaneous::Assigned(of, when, how_long, meaning) => {
                        assert_eq!(Some(of), matter(group), "M{code:02}");
                        (meaning, group.clone(), hold(how_long), start(when))
                    }
                    Miscellaneous::Unassigned => ("unassigned", String::new(), "", ""),
                    Miscellaneous::PermanentlyUnassigned => ("permanently unassigned", String::new(), "", ""),
                },
            };
            assert_eq!(found, (meaning.as_str(), group.clone(), holds.as_str(), starts.as_str()), "{letter}{code:02}");
        }
    }
    assert_eq!(preparatory(100), Preparatory::Unassigned);
    assert_eq!(miscellaneous(255), Miscellaneous::Unassigned);
}

/// The nine letters of groups that a note of JB 3208-83 counts, and the offsets, which any of d cancels.
#[test]
fn every_group_of_the_table_is_a_register() {
    let mut letters: Vec<&str> = Group::MODAL.iter().map(|group| group.letter()).collect();
    letters.sort_unstable();
    assert_eq!(letters, ["(d)", "a", "c", "d", "e", "f", "h", "i", "j", "k"]);
}

/// Every code on which the sources differ says so, and no other one does.
#[test]
fn where_the_sources_differ() {
    let of = |conflict: fn(u8) -> Option<&'static str>| (0..=99).filter(move |&code| conflict(code).is_some());
    let preparatory_ones: Vec<u8> = of(preparatory_conflict).collect();
    let expected = [5, 10, 11, 12, 13, 14, 15, 16].into_iter().chain(25..=29).chain(36..=39).chain(43..=50);
    let expected: Vec<u8> = expected.chain(60..=63).chain(68..=75).collect();
    assert_eq!(preparatory_ones, expected);
    let miscellaneous_ones: Vec<u8> = of(miscellaneous_conflict).collect();
    let expected: Vec<u8> = [12].into_iter().chain(32..=35).chain(40..=45).collect();
    let expected = expected.into_iter().chain([47, 48, 58, 59, 60, 62, 68, 69, 71, 72, 78, 79]);
    assert_eq!(miscellaneous_ones, expected.collect::<Vec<u8>>());
}
