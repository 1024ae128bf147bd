//! What one pass over all blocks tells of a tape.

use super::block::{Block, Traits};

/// What the rules on a whole tape would otherwise go through all blocks for, each by itself: with a hundred thousand
/// blocks such a pass waits for the memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Survey {
    /// What is in any block: a rule that looks for something else has nothing to do.
    pub traits: Traits,
    /// A block can be skipped.
    pub skips: bool,
    /// In each program the sequence numbers rise: none is repeated and none falls.
    pub rises: bool,
}

impl Default for Survey {
    fn default() -> Survey {
        Survey { traits: Traits::default(), skips: false, rises: true }
    }
}

impl Survey {
    pub(super) fn of(blocks: &[Block]) -> Survey {
        let mut survey = Survey::default();
        let mut last = None;
        for block in blocks {
            survey.traits = survey.traits.with(block.traits);
            survey.skips |= block.skip;
            if let Some(number) = block.sequence_number() {
                let this = Some((block.program, number));
                survey.rises &= last < this;
                last = this;
            }
        }
        survey
    }
}
