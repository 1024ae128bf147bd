//! TAB-08: the column of the tab and the address disagree.

use crate::read::Block;
use crate::rules::prelude::*;

/// The rule.
pub static RULE: Rule = Rule {
    name: "tab-and-address-disagree",
    title: "The column of the tab and the address disagree.",
    verdicts: Verdicts::all("TAB-08", Severity::Warning),
    clauses: &[Clause::Both("C.1.2"), Clause::Both("annex D")],
    page: page!("TAB-08"),
};

/// Said once, with how many blocks it holds for.
pub(crate) fn check(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    // Words without their tabs are a matter of TAB-04 and TAB-05.
    if tape.control.system != System::TabAndAddress || !tape.seen.any(Traits::TAB) {
        return;
    }
    let found: Vec<(&Block, Disagreement)> =
        tape.reading.blocks.iter().filter_map(|block| Some((block, disagreement(block, tape)?))).collect();
    let Some((block, first)) = found.first() else { return };
    let word = &tape.reading.words(block)[first.word];
    let there = tape.control.detail.words.get(first.column);
    let message = format!(
        "By its tabs this is column {}{}, but the address is {}, which has column {}. The address holds; a word that is \
         left out keeps its tab. Put the tabs right.",
        first.column,
        there.map_or(String::new(), |word| format!(" ({})", word.address)),
        word.letter(),
        first.wanted
    );
    let edits: Option<Vec<_>> = found.iter().map(|(block, _)| edits(block, tape)).collect();
    sink.report(&RULE, tape.range(block, word), message)
        .count(found.len())
        .fixes(edits.map(|edits| Fix::edits("Put the tabs right", edits.into_iter().flatten())));
}

/// The first word of a block that does not stand in its column.
struct Disagreement {
    word: usize,
    /// The column that its tabs lead to, the sequence number having none.
    column: usize,
    wanted: usize,
}

fn disagreement(block: &Block, tape: &TapeView<'_>) -> Option<Disagreement> {
    let words = tape.reading.words(block);
    let (mut column, mut before) = (0, 0);
    let detail = &tape.control.detail.words;
    let last = detail.len() - usize::from(detail.first().is_some_and(|first| first.address == 'N'));
    for (index, word) in words.iter().enumerate() {
        // Tabs that are missing, in the wrong place or too many to count are reported for that.
        let counted = word.is_sequence() && index == 0 && word.tabs == 0 || !word.is_sequence() && word.tabs > 0;
        let wanted = column_of(word, tape)?;
        if !counted {
            return None;
        }
        column += usize::from(word.tabs);
        // A word that may come again stands behind itself.
        let again = index > 0 && words[index - 1].address == word.address && word.tabs == 1;
        if again {
            column -= 1;
        }
        if wanted < before {
            return None;
        }
        before = wanted;
        // Beyond the last column: TAB-03.
        if column > last {
            return None;
        }
        if column != wanted {
            return Some(Disagreement { word: index, column, wanted });
        }
    }
    None
}

/// The column of an address: its place in the detail, the sequence number being 0.
fn column_of(word: &Word, tape: &TapeView<'_>) -> Option<usize> {
    let words = &tape.control.detail.words;
    let address = if word.address == b':' { 'N' } else { word.letter() };
    let place = words.iter().position(|column| column.address == address)?;
    let headed = words.first().is_some_and(|first| first.address == 'N');
    Some(place + usize::from(!headed))
}

/// The edits that put each word of a block into its column; `None` where its words are in another order.
fn edits(block: &Block, tape: &TapeView<'_>) -> Option<Vec<(std::ops::Range<usize>, String)>> {
    let (mut edits, mut before) = (Vec::new(), 0);
    for word in tape.reading.words(block) {
        let column = column_of(word, tape)?;
        let wanted = column.checked_sub(before)?;
        let (at, has) = (tape.range(block, word).start, usize::from(word.tabs));
        let tabs = tape.text[block.range.start..at].bytes().rev().take_while(|&byte| byte == b'\t').count();
        match wanted.cmp(&has) {
            std::cmp::Ordering::Greater => edits.push((at..at, "\t".repeat(wanted - has))),
            std::cmp::Ordering::Less if wanted > 0 && tabs >= has - wanted => {
                edits.push((at - (has - wanted)..at, String::new()));
            }
            std::cmp::Ordering::Less if wanted > 0 => return None,
            _ => {}
        }
        before = column;
    }
    Some(edits)
}
