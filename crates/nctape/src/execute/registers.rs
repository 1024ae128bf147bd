//! What the control holds behind a block: what a control shows in its registers.

use super::feed::Feed;
use super::run_block;
use super::state::State;
use super::walk::{Fate, Walk, stop_of};
use crate::Tape;
use crate::format::{Control, Dimensions, FeedCoding, FeedUnit, Plane, Sign, Standard};
use crate::function::{
    Group, Miscellaneous, Preparatory, miscellaneous, miscellaneous_conflict, preparatory, preparatory_conflict,
};
use crate::read::{Reading, Traits, Word};
use std::ops::Range;

/// What the control holds behind a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Registers {
    /// What becomes of the block. Where it is not executed, the control holds what it held before.
    pub fate: Fate,
    /// The digits behind the program start character.
    pub program: Option<String>,
    /// The sequence number last read, as written.
    pub sequence: Option<String>,
    /// The preparatory functions in force, group by group: every group that the control starts with a choice of, and
    /// every one of which the tape has a function.
    pub modal: Vec<Modal>,
    /// What acts in this block alone: preparatory functions of no group, and its miscellaneous functions.
    pub once: Vec<Named>,
    /// The function of the block that makes the control wait behind it.
    pub stop: Option<Named>,
    /// How long the block dwells; `None` where it does not, or where the format states no word for it.
    pub dwell: Option<Dwelling>,
    /// Where every axis stands, in the unit of the format.
    pub position: Vec<f64>,
    /// The axes whose position is a guess, because a word could not be read.
    pub doubtful: Vec<bool>,
    /// The feed in force.
    pub feed: Option<Rate>,
    /// The leads of a thread in force, along X, Y and Z in the unit of the format; `None` but under G33 to G35.
    pub leads: Option<[f64; 3]>,
    /// The spindle speed in force.
    pub speed: Option<Rate>,
    /// Whether the spindle turns; `None` while the tape has not said.
    pub spindle: Option<(Turning, Named)>,
    /// Whether coolant is on; `None` while the tape has not said.
    pub coolant: Option<(bool, Named)>,
    /// The tool word in force, as written, and the tool change given since.
    pub tool: Option<(String, Option<Named>)>,
    /// The number of the tool compensation in force: the last digits of T, or the word D; `None` while the tape has
    /// given none.
    pub compensation: Option<String>,
    /// Every other address of the detail that is no dimension, with its last word as written: the position of an
    /// indexed table, say.
    pub others: Vec<(char, Option<String>)>,
}

/// The function of a group that is in force.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Modal {
    /// The group.
    pub group: Group,
    /// The function; `None` while none of the group is in force.
    pub function: Option<Named>,
    /// The tape states it; else the control starts with it.
    pub stated: bool,
}

/// A function with its meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// "G02", "M30".
    pub code: String,
    /// What it means; empty for one without meaning.
    pub meaning: String,
    /// What its group is about; empty where it has none.
    pub group: &'static str,
    /// When it begins to act and how long it does; empty where nothing says so.
    pub acts: String,
    /// Where the sources of the tables differ.
    pub conflict: Option<&'static str>,
}

/// A feed or spindle speed word.
#[derive(Clone, Debug, PartialEq)]
pub struct Rate {
    /// As written.
    pub word: String,
    /// Unit or revolutions per minute; `None` where the word alone does not say it.
    pub per_minute: Option<f64>,
}

/// A dwell: its word as written, and how long it lasts.
#[derive(Clone, Debug, PartialEq)]
pub struct Dwelling {
    /// As written.
    pub word: String,
    /// `None` where its number cannot be read, or where it is counted in revolutions and the spindle speed is not known.
    pub seconds: Option<f64>,
}

/// What the spindle does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turning {
    /// It stands.
    Still,
    /// It turns clockwise.
    Clockwise,
    /// It turns counter-clockwise.
    CounterClockwise,
}

impl Turning {
    /// Its name in the interface.
    pub fn name(self) -> &'static str {
        match self {
            Turning::Still => "still",
            Turning::Clockwise => "clockwise",
            Turning::CounterClockwise => "counter-clockwise",
        }
    }
}

impl Tape {
    /// What the control holds behind a block; `None` beyond the last one.
    pub fn registers(&self, block: usize) -> Option<Registers> {
        self.registers_of(block..block.saturating_add(1)).pop()
    }

    /// What the control holds behind each of some blocks: many cost little more than one.
    pub fn registers_of(&self, blocks: Range<usize>) -> Vec<Registers> {
        let (control, reading) = (self.control(), self.reading());
        let mut state = State::new(control);
        let mut held = Held::new(control);
        let mut walk = Walk::new(self.skip());
        let used = used_groups(reading);
        // Words are cheap to look through; motions are worked out from the last mark on.
        let mark = self.execution().mark_before(blocks.start);
        let first = mark.map_or(0, |mark| mark.block);
        let mut all = Vec::new();
        for (index, block) in reading.blocks.iter().enumerate().take(blocks.end) {
            let words = reading.words(block);
            if let Some(mark) = mark.filter(|mark| mark.block == index) {
                state.take_over(&mark.carried);
            }
            let (fate, restarts) = walk.meet(block, words);
            if restarts {
                state.finish_span();
                state.restart();
                held.restart(control);
            }
            if fate == Fate::Executed {
                if index >= first {
                    run_block(&mut state, index, block, words);
                }
                held.take(index, words);
            }
            if index >= blocks.start {
                all.push(self.show(index, fate, &held, &state, &used));
            }
        }
        all
    }

    fn show(&self, index: usize, fate: Fate, held: &Held, state: &State<'_>, used: &[bool; GROUPS]) -> Registers {
        let (control, reading) = (self.control(), self.reading());
        let block = &reading.blocks[index];
        let written = |(block, place): (usize, usize)| {
            let block = &reading.blocks[block];
            self.text()[reading.range(block, &reading.words(block)[place])].replace(' ', "")
        };
        let modal = Group::MODAL.iter().enumerate().filter_map(|(slot, &group)| {
            let said = held.modal[slot];
            (said.is_some() || used[slot]).then(|| Modal {
                group,
                function: said.map(|said| preparatory_named(control, said.code)),
                stated: said.is_some_and(|said| said.stated),
            })
        });
        let words = if fate == Fate::Executed { reading.words(block) } else { &[] };
        let finite = |number: f64| Some(number).filter(|number| number.is_finite());
        let per_minute = match state.feed {
            Feed::PerMinute(feed) => finite(feed),
            Feed::PerRevolution(feed) => state.speed.and_then(|speed| finite(feed * speed)),
            Feed::Rapid => control.format.itemized.rapid.map(|rapid| rapid.0),
            Feed::None | Feed::Reciprocal(_) | Feed::Unknown => None,
        };
        // A point of a span that is not complete yet is held, but the tool has not gone there.
        let position = state.pending.map_or(state.position, |pending| pending.start);
        Registers {
            fate,
            program: (block.program as usize)
                .checked_sub(1)
                .and_then(|mark| reading.programs().nth(mark))
                .map(|mark| self.text()[mark.number].replace(' ', ""))
                .filter(|number| !number.is_empty()),
            sequence: held.sequence.map(written),
            modal: modal.collect(),
            once: once(control, words),
            dwell: state
                .pause
                .filter(|_| fate == Fate::Executed)
                .map(|pause| Dwelling { word: written((index, pause.place)), seconds: pause.seconds }),
            stop: stop_of(words).map(|code| miscellaneous_named(control, code)),
            position: position.iter().enumerate().map(|(axis, &at)| state.in_unit(axis, at)).collect(),
            doubtful: (0..position.len()).map(|axis| state.is_lost(axis)).collect(),
            feed: held.feed.filter(|_| state.feed != Feed::None).map(|word| Rate { word: written(word), per_minute }),
            leads: state.leads_in_force(),
            speed: held.speed.map(|word| Rate { word: written(word), per_minute: state.speed.and_then(finite) }),
            spindle: held.spindle.map(|(turning, code)| (turning, miscellaneous_named(control, code))),
            coolant: held.coolant.map(|(on, code)| (on, miscellaneous_named(control, code))),
            tool: held
                .tool
                .map(|word| (written(word), held.tool_change.map(|code| miscellaneous_named(control, code)))),
            compensation: held.compensation.map(|word| {
                let word = written(word);
                // A character that no code has may stand among them.
                let digits: String = word.chars().filter(char::is_ascii_digit).collect();
                let count = usize::from(control.format.itemized.compensation_digits.unwrap_or(0));
                let first = if word.starts_with(['D', 'd']) { 0 } else { digits.len().saturating_sub(count) };
                digits[first..].to_owned()
            }),
            others: held.others.iter().map(|&(letter, word)| (char::from(letter), word.map(written))).collect(),
        }
    }
}

const GROUPS: usize = Group::MODAL.len();

/// A preparatory function in force.
#[derive(Clone, Copy)]
struct Said {
    code: u8,
    stated: bool,
}

/// What is in force beside what executing itself keeps. A word is told by its block and its place there.
struct Held {
    modal: [Option<Said>; GROUPS],
    sequence: Option<(usize, usize)>,
    feed: Option<(usize, usize)>,
    speed: Option<(usize, usize)>,
    spindle: Option<(Turning, u8)>,
    coolant: Option<(bool, u8)>,
    tool: Option<(usize, usize)>,
    tool_change: Option<u8>,
    /// The word that selects the tool compensation.
    compensation: Option<(usize, usize)>,
    /// The last digits of T do, and D does.
    compensates: (bool, bool),
    others: Vec<(u8, Option<(usize, usize)>)>,
    /// The address of the word that a dwell counts by.
    dwell: Option<char>,
    /// The G codes that the itemized data declares as curves: they belong to the group of motions.
    curves: Vec<u8>,
}

impl Held {
    fn new(control: &Control) -> Held {
        let curves = control.format.itemized.curves.iter().flat_map(|curves| curves.keys());
        Held {
            modal: at_the_start(control),
            sequence: None,
            feed: None,
            speed: None,
            spindle: None,
            coolant: None,
            tool: None,
            tool_change: None,
            compensation: None,
            compensates: compensates(control),
            others: other_letters(control),
            dwell: control.format.itemized.dwell.as_ref().map(|dwell| dwell.address),
            curves: curves.filter_map(|name| name.strip_prefix('G')?.parse().ok()).collect(),
        }
    }

    /// Another program begins. What is no modal function stays as the machine stands: spindle, coolant, tool.
    fn restart(&mut self, control: &Control) {
        self.modal = at_the_start(control);
        (self.sequence, self.feed, self.speed) = (None, None, None);
    }

    fn take(&mut self, block: usize, words: &[Word]) {
        // A word that says how long the block dwells says nothing else.
        let dwells = self.dwell.is_some() && words.iter().any(|word| word.function(b'G') == Some(4));
        for (place, word) in words.iter().enumerate() {
            let at = Some((block, place));
            match word.address {
                _ if dwells && Some(word.letter()) == self.dwell => {}
                _ if word.is_sequence() => self.sequence = at,
                b'G' => word.function(b'G').into_iter().for_each(|code| self.take_preparatory(code)),
                b'F' => self.feed = at,
                b'S' => self.speed = at,
                b'T' => {
                    self.tool = at;
                    self.tool_change = None;
                    self.compensation = at.filter(|_| self.compensates.0).or(self.compensation);
                }
                letter => {
                    self.compensation = at.filter(|_| letter == b'D' && self.compensates.1).or(self.compensation);
                    let other = self.others.iter_mut().find(|(other, _)| *other == letter);
                    other.into_iter().for_each(|(_, word)| *word = at);
                }
            }
        }
        // The tool of a block is known before its change, in whatever order they stand.
        words.iter().filter_map(|word| word.function(b'M')).for_each(|code| self.take_miscellaneous(code));
    }

    fn take_preparatory(&mut self, code: u8) {
        let group = match preparatory(code) {
            Preparatory::Assigned(group, _) => group,
            _ if self.curves.contains(&code) => Group::Motion,
            _ => return,
        };
        let Some(slot) = slot_of(group) else { return };
        self.modal[slot] = Some(Said { code, stated: true });
        match group {
            // Any function of d cancels the offsets.
            Group::Compensation => slot_of(Group::Offset).into_iter().for_each(|slot| self.modal[slot] = None),
            // Revolutions say nothing of a cutting speed: S must be given again.
            Group::Spindle => self.speed = None,
            _ => {}
        }
    }

    fn take_miscellaneous(&mut self, code: u8) {
        let turning = match code {
            3 | 13 => Some(Turning::Clockwise),
            4 | 14 => Some(Turning::CounterClockwise),
            // A stop and an end stop the spindle and the coolant too: so RS-274-D defines them, recalled.
            0 | 2 | 5 | 19 | 30 => Some(Turning::Still),
            _ => None,
        };
        self.spindle = turning.map(|turning| (turning, code)).or(self.spindle);
        let coolant = match code {
            7 | 8 | 13 | 14 | 50 | 51 => Some(true),
            0 | 2 | 9 | 30 => Some(false),
            _ => None,
        };
        self.coolant = coolant.map(|on| (on, code)).or(self.coolant);
        if code == 6 {
            self.tool_change = Some(code);
        }
    }
}

/// Whether the last digits of T select a tool compensation, and whether D does: where it is neither a dimension nor
/// declared as anything else (3.3.4.5).
fn compensates(control: &Control) -> (bool, bool) {
    let stated = &control.format.itemized;
    let by_tool = stated.compensation_digits.is_some_and(|digits| digits > 0);
    let is_number = control.designation(b'D').is_some_and(|word| !word.dimension);
    let declared = stated.declared.as_ref().and_then(|declared| declared.letters.get("D"));
    let named = declared.is_some_and(|meaning| meaning.contains("compensation") || meaning.contains("offset"));
    (by_tool, is_number && named)
}

/// The addresses that have no register of their own.
fn other_letters(control: &Control) -> Vec<(u8, Option<(usize, usize)>)> {
    let mut letters: Vec<(u8, _)> = Vec::new();
    for word in control.detail.words.iter().filter(|word| !word.dimension && !"NGFSTMIJK".contains(word.address)) {
        if let Ok(letter) = u8::try_from(word.address)
            && !letters.iter().any(|(other, _)| *other == letter)
        {
            letters.push((letter, None));
        }
    }
    letters
}

fn slot_of(group: Group) -> Option<usize> {
    Group::MODAL.iter().position(|&other| other == group)
}

/// The functions that hold before the tape has stated any: what the format says of the control.
fn at_the_start(control: &Control) -> [Option<Said>; GROUPS] {
    let mut modal = [None; GROUPS];
    let mut set = |group, code| {
        if let Some(slot) = slot_of(group) {
            modal[slot] = Some(Said { code, stated: false });
        }
    };
    let plane = match control.plane {
        Plane::Xy => 17,
        Plane::Zx => 18,
        Plane::Yz => 19,
    };
    set(Group::Plane, plane);
    set(Group::Dimensions, if starts_incremental(control) { 91 } else { 90 });
    let feed = match (control.feed, control.feed_unit) {
        (FeedCoding::TimeReciprocal, _) => 93,
        (_, FeedUnit::PerMinute) => 94,
        (_, FeedUnit::PerRevolution) => 95,
    };
    set(Group::Feed, feed);
    modal
}

/// Dimensions are incremental at the start: by the detail, where its words leave no choice.
fn starts_incremental(control: &Control) -> bool {
    let signs = || control.axes.iter().filter_map(|axis| axis.sign);
    let chosen = control.standard() == Standard::Rs274 || signs().any(|sign| sign == Sign::Both);
    match chosen {
        true => control.dimensions == Dimensions::Incremental,
        false => signs().any(|sign| sign == Sign::Incremental),
    }
}

/// The groups of which a tape has a function.
fn used_groups(reading: &Reading) -> [bool; GROUPS] {
    let mut used = [false; GROUPS];
    let blocks = reading.blocks.iter().filter(|block| block.traits.any(Traits::address(b'G')));
    for code in blocks.flat_map(|block| reading.words(block)).filter_map(|word| word.function(b'G')) {
        if let Preparatory::Assigned(group, _) = preparatory(code)
            && let Some(slot) = slot_of(group)
        {
            used[slot] = true;
        }
    }
    // How the tool moves is shown of any tape: that nothing has been said of it yet is worth knowing.
    slot_of(Group::Motion).into_iter().for_each(|slot| used[slot] = true);
    used
}

fn once(control: &Control, words: &[Word]) -> Vec<Named> {
    let preparatory_ones =
        words.iter().filter_map(|word| word.function(b'G')).filter(|&code| match preparatory(code) {
            Preparatory::Assigned(group, _) => group == Group::Once,
            _ => !control.format.itemized.curves.as_ref().is_some_and(|all| all.contains_key(&format!("G{code:02}"))),
        });
    let miscellaneous_ones = words.iter().filter_map(|word| word.function(b'M'));
    preparatory_ones
        .map(|code| preparatory_named(control, code))
        .chain(miscellaneous_ones.map(|code| miscellaneous_named(control, code)))
        .collect()
}

fn preparatory_named(control: &Control, code: u8) -> Named {
    let name = format!("G{code:02}");
    let stated = &control.format.itemized;
    let (meaning, group) = match preparatory(code) {
        Preparatory::Assigned(group, meaning) => (meaning, Some(group)),
        _ if stated.curves.as_ref().is_some_and(|curves| curves.contains_key(&name)) => {
            ("Curve of higher order", Some(Group::Motion))
        }
        _ => (stated.declared.as_ref().and_then(|declared| declared.g.get(&name)).map_or("", String::as_str), None),
    };
    Named {
        meaning: meaning.to_owned(),
        code: name,
        group: group.map_or("", Group::title),
        acts: group.map_or("", |group| group.hold().words()).to_owned(),
        conflict: preparatory_conflict(code),
    }
}

fn miscellaneous_named(control: &Control, code: u8) -> Named {
    let name = format!("M{code:02}");
    let declared = control.format.itemized.declared.as_ref().and_then(|declared| declared.m.get(&name));
    let (meaning, group, acts) = match miscellaneous(code) {
        Miscellaneous::Assigned(matter, start, hold, meaning) => {
            (meaning, matter.title(), format!("{}, {}", start.words(), hold.words()))
        }
        _ => (declared.map_or("", String::as_str), "", String::new()),
    };
    // What the builder declares of an assigned function says what the table leaves open.
    let acts = declared.filter(|_| !group.is_empty()).cloned().unwrap_or(acts);
    Named { meaning: meaning.to_owned(), code: name, group, acts, conflict: miscellaneous_conflict(code) }
}
