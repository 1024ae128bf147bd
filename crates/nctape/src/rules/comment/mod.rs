//! CTRL: control out and control in.

pub(crate) mod colon;
pub(crate) mod nested;
pub(crate) mod percent;
pub(crate) mod swallowed;
pub(crate) mod unclosed;
pub(crate) mod unopened;

use crate::read::{BlockView, Stray, StrayKind};

/// What stands in the comments of a block that are closed. Where nothing closes one, all that follows is comment, and
/// CTRL-01 says so.
fn strays<'a>(block: &BlockView<'a>) -> impl Iterator<Item = &'a Stray> {
    let unclosed = block.strays.iter().find(|stray| stray.kind == StrayKind::Unclosed);
    let end = unclosed.map_or(u32::MAX, |stray| stray.from);
    block.strays.iter().filter(move |stray| stray.from < end)
}
