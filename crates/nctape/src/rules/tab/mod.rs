//! TAB: tabulation.

pub(crate) mod in_address_system;
pub(crate) mod mixed;
pub(crate) mod too_many;

use crate::read::BlockView;
use crate::text::{Listing, Mark};

/// Where the tabs of a block stand, those in comments left out.
pub(crate) fn tabs(block: &BlockView<'_>) -> Vec<usize> {
    let tabs = Listing::new(block.text).filter(|it| it.mark == Mark::Character('\t') && !it.comment);
    tabs.map(|tab| tab.from).collect()
}
