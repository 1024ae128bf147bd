//! TAB: tabulation.

pub(crate) mod address_in_tab_system;
pub(crate) mod behind_address;
pub(crate) mod in_address_system;
pub(crate) mod missing;
pub(crate) mod mixed;
pub(crate) mod other_column;
pub(crate) mod sign_only;
pub(crate) mod too_many;
pub(crate) mod wrong_column;

use crate::read::{BlockView, StrayKind};
use crate::text::{Listing, Mark};

/// Where the tabs of a block stand, those in comments left out, and those behind an address (TAB-06).
pub(crate) fn tabs(block: &BlockView<'_>) -> Vec<usize> {
    if !block.tab {
        return Vec::new();
    }
    let tabs = Listing::new(block.text).filter(|it| it.mark == Mark::Character('\t') && !it.comment);
    let mut slipped = block.strays.iter().filter(|stray| stray.kind == StrayKind::TabBehindAddress).peekable();
    // Both are in order.
    let mut slipped = |at: usize| {
        while slipped.next_if(|stray| stray.range().start < at).is_some() {}
        slipped.peek().is_some_and(|stray| stray.range().start == at)
    };
    tabs.map(|tab| tab.from).filter(|&at| !slipped(at)).collect()
}
