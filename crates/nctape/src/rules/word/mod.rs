//! WORD: addresses and their order.

pub(crate) mod axis_feed;
pub(crate) mod common_feed;
pub(crate) mod compensation_letter;
pub(crate) mod contouring_feed;
pub(crate) mod dimension_order;
pub(crate) mod letter_for_digit;
pub(crate) mod letter_o;
pub(crate) mod no_address;
pub(crate) mod no_digits;
pub(crate) mod no_tool_change;
pub(crate) mod order;
pub(crate) mod parameters;
pub(crate) mod repeated;
pub(crate) mod trailing_tabs;
pub(crate) mod two_miscellaneous;
pub(crate) mod two_tools;
pub(crate) mod unassigned_letter;
pub(crate) mod undeclared_meaning;
pub(crate) mod unknown_address;

use crate::format::Control;
use crate::function::{Group, Preparatory, preparatory};
use crate::read::{Block, Traits, Word};
use crate::rules::TapeView;

/// Letters that rules of their own speak of: the general rule on unknown addresses keeps quiet about them.
fn has_rule_of_its_own(word: &Word, control: &Control) -> bool {
    match word.address {
        b'H' | b'L' | b'O' => true,
        b'I' | b'J' | b'K' => control.standard() == crate::format::Standard::Iso1058,
        _ => false,
    }
}

/// The address stands in the detail, or the itemized data gives it a meaning.
fn is_known(word: &Word, control: &Control) -> bool {
    control.designation(word.address).is_some()
        || word.address == b':' && control.designation(b'N').is_some()
        || crate::rules::is_declared_letter(word.letter(), control)
}

/// A block with feed words, as the rules on their place see it.
pub(crate) struct FeedWords<'a> {
    block: &'a Block,
    words: &'a [Word],
    /// The block cuts along a path: an interpolation code is in force.
    contouring: bool,
}

impl FeedWords<'_> {
    /// The places of the feed words among the words.
    fn feeds<'a>(&'a self, control: &'a Control) -> impl Iterator<Item = usize> + 'a {
        self.words.iter().enumerate().filter(|(_, word)| is_feed(word, control)).map(|(place, _)| place)
    }

    fn is_dimension(&self, place: usize, control: &Control) -> bool {
        control.designation(self.words[place].address).is_some_and(|word| word.dimension)
    }
}

/// The blocks of a tape whose feed words want a look.
pub(crate) fn feed_words<'a>(tape: &TapeView<'a>) -> impl Iterator<Item = FeedWords<'a>> {
    let reading = tape.reading;
    let mut contouring = false;
    let concerns = Traits::address(b'G').with(Traits::FEED_PLACES);
    let blocks = if tape.seen.any(Traits::FEED_PLACES) { reading.blocks.as_slice() } else { &[] };
    let blocks = blocks.iter().filter(move |block| block.traits.any(concerns));
    blocks.filter_map(move |block| {
        let words = reading.words(block);
        for code in words.iter().filter_map(|word| word.function(b'G')) {
            if let Preparatory::Assigned(Group::Motion, _) = preparatory(code) {
                contouring = code != 0;
            }
        }
        block.traits.any(Traits::FEED_PLACES).then_some(FeedWords { block, words, contouring })
    })
}

/// A block has more than one feed word, or one before a dimension word. One behind all dimension words is as every rule
/// wants it.
pub(crate) fn wants_look(words: &[Word], control: &Control) -> bool {
    let dimension = |word: &Word| control.designation(word.address).is_some_and(|word| word.dimension);
    let first = words.iter().position(|word| is_feed(word, control));
    first.is_some_and(|first| words[first + 1..].iter().any(|word| is_feed(word, control) || dimension(word)))
}

/// F, and E and D where the detail makes them the second and the third feed function (B.1).
fn is_feed(word: &Word, control: &Control) -> bool {
    let function = || control.designation(word.address).is_some_and(|designation| !designation.dimension);
    word.address == b'F' || matches!(word.address, b'D' | b'E') && function()
}
