//! FEED-15: a block is cut faster than it is read.

use crate::execute::{ZeroRows, cut_and_read};
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "reader-too-slow",
    title: "A block is cut faster than it is read.",
    verdicts: Verdicts::all("FEED-15", Severity::Warning),
    clauses: &[Clause::Both("3.3.1")],
    page: page!("FEED-15"),
};

/// Said once, at the first block, with how many it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    let format = &tape.control.format;
    let reader_speed = format.reader_speed();
    let blocks = &tape.reading.blocks;
    let starved = tape.execution.starved;
    let span = starved.first.map(|first| &tape.execution.spans.list[first]);
    let Some((span, (cut, read))) = span.and_then(|span| Some((span, cut_and_read(span, blocks, reader_speed)?)))
    else {
        return;
    };
    let range = span.blocks.0..=span.blocks.1;
    let rows: usize = blocks.get(range.clone()).map_or(0, |blocks| blocks.iter().map(|block| block.rows).sum());
    let (count, wait) = (starved.count, starved.wait());
    let what = if span.blocks.0 == span.blocks.1 { "The block has" } else { "The blocks of this span have" };
    let pace = if format.itemized.reader_speed.is_some() { "" } else { ", which is assumed" };
    let mut message = format!(
        "{what} {rows} rows, which take {} s to read at {reader_speed} rows/s (readerSpeed{pace}), and {} cut in {} s: \
         the tool stands in the cut and waits for the tape",
        said(read),
        if span.blocks.0 == span.blocks.1 { "is" } else { "are" },
        said(cut)
    );
    message += &match (count, format.is_buffered()) {
        (_, false) => ". There is no buffer: it waits for the reading of every block.".to_owned(),
        (1, true) => format!(", {} s. Cut slower, or write longer spans.", said(wait)),
        (_, true) => format!(", {} s over all such blocks. Cut slower, or write longer spans.", said(wait)),
    };
    let zeros = range.map(|block| ZeroRows::of(tape.reading.words(&blocks[block]), tape.control));
    let (permitted, most) = zeros.fold((0, 0), |sum, zeros| (sum.0 + zeros.permitted, sum.1 + zeros.most()));
    let counted = |rows: usize| if rows == 1 { "1 row".to_owned() } else { format!("{rows} rows") };
    if permitted > 0 {
        message += &format!(" Zeros that the format lets go take {} of it.", counted(permitted));
    } else if most > 0 {
        message += &format!(" A format that lets zeros go would save {} of it.", counted(most));
    }
    sink.report(&RULE, tape.extent(span.blocks.0), message).count(count);
}

/// Seconds with three figures or so.
fn said(seconds: f64) -> String {
    match seconds {
        _ if seconds >= 100.0 => format!("{seconds:.0}"),
        _ if seconds >= 1.0 => format!("{seconds:.2}"),
        _ => format!("{seconds:.3}"),
    }
}
