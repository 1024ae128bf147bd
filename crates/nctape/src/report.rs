//! All that was found in a tape: by the rules of reading, kept with the blocks, and by those on the whole tape.

use crate::diagnostic::{Diagnostic, Severity};
use crate::execute::Execution;
use crate::read::{Block, Found, NumberFault, Reading, Word};
use crate::rules::{Rule, comment, tape};
use std::ops::Range;

/// What the rules on a whole tape found, and how much was found of each weight.
#[derive(Clone, Debug, Default)]
pub(crate) struct Findings {
    whole: Vec<Diagnostic>,
    /// The text is no tape: what reading found in it is no matter.
    foreign: bool,
    outside: Outside,
    counts: [usize; 3],
}

/// What stands outside of every program: behind an M02 or M30, up to where another program begins.
#[derive(Clone, Debug, Default)]
struct Outside {
    stretches: Vec<Range<usize>>,
    /// The starts of the blocks there that hold an address without digits: text, or what a slip has left of a block.
    texts: Vec<usize>,
}

impl Outside {
    fn new(reading: &Reading, execution: &Execution) -> Outside {
        let blocks = &reading.blocks;
        let holds_word = |block: &Block| !reading.words(block).is_empty();
        let mut stretches = Vec::new();
        let mut first = 0;
        for (place, &(last, ended)) in execution.ends.iter().enumerate() {
            let program = std::mem::replace(&mut first, last + 1);
            if !ended {
                continue;
            }
            let behind = execution.unreached.partition_point(|&index| index < program);
            let behind = execution.unreached.get(behind).filter(|&&index| index <= last);
            let from = behind.map_or(blocks[last].range.end, |&index| blocks[index].range.start);
            let next = execution.ends.get(place + 1).map_or(first..first, |next| first..next.0 + 1);
            let another = blocks[next].iter().any(holds_word);
            let to = if another { reading.program_start(blocks[first].program) } else { usize::MAX };
            stretches.push(from..to);
        }
        let bare = |word: &Word| word.fault == NumberFault::Empty && word.address != 0 && !word.by_column;
        let unreached = execution.unreached.iter().map(|&index| &blocks[index]);
        let texts = unreached.filter(|block| reading.words(block).iter().any(bare)).map(|block| block.range.start);
        Outside { texts: texts.collect(), stretches }
    }

    /// A finding of reading is no matter here: a comment may hold what it likes outside of a program (B.2), and of a block
    /// that is no block only that it is never executed is said, and what its characters are on the tape.
    fn hushes(&self, found: &Found) -> bool {
        let rule = found.diagnostic.rule;
        let is = |other: &Rule| std::ptr::eq(rule, other);
        let at = found.origin + found.diagnostic.range.start;
        if is(&comment::colon::RULE) || is(&comment::percent::RULE) {
            let behind = self.stretches.partition_point(|stretch| stretch.start <= at);
            return behind > 0 && at < self.stretches[behind - 1].end;
        }
        let text = !self.texts.is_empty() && self.texts.binary_search(&found.origin).is_ok();
        text && !is(&tape::foreign_character::RULE) && rule.family() != "CTRL"
    }
}

impl Findings {
    pub(crate) fn new(whole: Vec<Diagnostic>, reading: &Reading, execution: &Execution, foreign: bool) -> Findings {
        let outside = Outside::new(reading, execution);
        let mut findings = Findings { whole, foreign, outside, counts: [0; 3] };
        let own = findings.own(reading).map(|found| found.diagnostic.severity);
        let mut counts = [0; 3];
        for severity in findings.whole.iter().map(|found| found.severity).chain(own) {
            counts[severity as usize] += 1;
        }
        findings.counts = counts;
        findings
    }

    /// What reading found that is said.
    fn own<'a>(&'a self, reading: &'a Reading) -> impl Iterator<Item = &'a Found> {
        let found = if self.foreign { &[] } else { reading.found() };
        found.iter().filter(|found| !self.outside.hushes(found))
    }

    pub(crate) fn count(&self, severity: Severity) -> usize {
        self.counts[severity as usize]
    }

    /// Those that touch a stretch of the text, by position, at most `limit`. At one place those on the whole tape come
    /// first, in the order of the list of rules.
    pub(crate) fn touching(&self, reading: &Reading, range: Range<usize>, limit: usize) -> Vec<Diagnostic> {
        let touches = |place: &Range<usize>| place.start <= range.end && place.end >= range.start;
        let whole = self.whole.iter().map(|diagnostic| (0, diagnostic));
        let own = self.own(reading).map(|found| (found.origin, &found.diagnostic));
        let placed = whole.chain(own).map(|(origin, diagnostic)| {
            let Range { start, end } = diagnostic.range;
            (origin + start..origin + end, origin, diagnostic)
        });
        let mut found: Vec<_> = placed.filter(|(place, ..)| touches(place)).collect();
        found.sort_by_key(|(place, ..)| (place.start, place.end));
        found.truncate(limit);
        found.into_iter().map(|(_, origin, diagnostic)| diagnostic.moved(origin)).collect()
    }
}
