//! Which blocks of a tape a control executes.

use crate::read::{Block, Traits, Word};

/// What becomes of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It is executed.
    Executed,
    /// The optional block skip switch leaves it out.
    Skipped,
    /// It stands behind the end of its program.
    Unreached,
}

impl Fate {
    /// Every fate, in the order of [`Fate::index`].
    pub const ALL: [Fate; 3] = [Fate::Executed, Fate::Skipped, Fate::Unreached];

    /// Its name in the interface.
    pub fn name(self) -> &'static str {
        match self {
            Fate::Executed => "executed",
            Fate::Skipped => "skipped",
            Fate::Unreached => "unreached",
        }
    }

    /// Its place in [`Fate::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }
}

/// Goes through the blocks of a tape as a control does: the one place that says which of them are executed.
pub(crate) struct Walk {
    skip: bool,
    program: Option<u32>,
    ended: bool,
}

impl Walk {
    pub(crate) fn new(skip: bool) -> Walk {
        Walk { skip, program: None, ended: false }
    }

    /// The same from behind a block on, where it is known whether its program has ended there.
    pub(super) fn behind(block: &Block, skip: bool, ended: bool) -> Walk {
        Walk { skip, program: Some(block.program), ended }
    }

    /// The program has ended before the next block.
    pub(super) fn ended(&self) -> bool {
        self.ended
    }

    /// The next block: its fate, and whether the modal state of the start holds again before it.
    pub(crate) fn meet(&mut self, block: &Block, words: &[Word]) -> (Fate, bool) {
        // Behind a program without its end, a program start character is a rewind stop and starts no other program.
        let restarts = self.program.replace(block.program) != Some(block.program) && self.ended;
        self.ended &= !restarts;
        let fate = match self.ended {
            true => Fate::Unreached,
            false if self.skip && block.skip => Fate::Skipped,
            false => Fate::Executed,
        };
        let may_end = fate == Fate::Executed && block.traits.any(Traits::address(b'M'));
        self.ended |= may_end && ends_program(words);
        (fate, restarts)
    }
}

/// The block ends its program: M02 or M30.
pub(crate) fn ends_program(words: &[Word]) -> bool {
    matches!(stop_of(words), Some(2 | 30))
}

/// The miscellaneous function behind which the control waits: an end goes before the program stop, M00.
pub(crate) fn stop_of(words: &[Word]) -> Option<u8> {
    let given = |wanted: &[u8]| words.iter().filter_map(|word| word.function(b'M')).find(|code| wanted.contains(code));
    given(&[2, 30]).or_else(|| given(&[0]))
}
