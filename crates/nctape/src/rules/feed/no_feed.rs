//! FEED-13: a cutting block has no feed.

use crate::execute::{Event, EventKind};
use crate::rules::prelude::*;
use std::collections::BTreeSet;

/// The rule.
pub static RULE: Rule = Rule {
    name: "cutting-without-feed",
    title: "A cutting block has no feed.",
    verdicts: Verdicts::all("FEED-13", Severity::Error),
    clauses: &[Clause::Iso2539("A.1 to A.5"), Clause::Iso1058("A.1 to A.3")],
    page: page!("FEED-13"),
};

/// Said once, with how many blocks it holds for. Not said where an F cannot be read, which is reported at that word, nor
/// of a block that is read as G01 because it has no function at all (FUN-05).
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let events = &tape.execution.events;
    if !events.iter().any(|event| matches!(event.kind, EventKind::NoFeed)) {
        return;
    }
    let blocks = &tape.reading.blocks;
    let unread =
        |index: usize| tape.reading.words(&blocks[index]).iter().any(|w| w.address == b'F' && w.value.is_none());
    let unread: Vec<usize> = (0..blocks.len()).filter(|&index| unread(index)).collect();
    let has_unread_feed = |index: usize| {
        let last = unread.partition_point(|&at| at <= index).checked_sub(1);
        last.is_some_and(|last| blocks[unread[last]].program == blocks[index].program)
    };
    // Under RS-274 a missing function is a note, which would be too little; one that was lost is an error.
    let says = tape.control.standard() == Standard::Iso2539;
    let assumed = events.iter().filter(|event| match event.kind {
        EventKind::NoInterpolation { lost } => lost || says,
        _ => false,
    });
    let assumed: BTreeSet<usize> = assumed.map(|event| event.block).collect();
    let lacks = |event: &&Event| matches!(event.kind, EventKind::NoFeed) && !has_unread_feed(event.block);
    let mut found = events.iter().filter(lacks);
    let Some(event) = found.find(|event| !assumed.contains(&event.block)) else { return };
    sink.report(
        &RULE,
        tape.extent(event.block),
        "The block cuts, but no F was given yet, or it is zero. Give the feed here or before.".to_owned(),
    )
    .count(1 + found.count());
}
