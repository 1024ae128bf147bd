//! All that was found in a tape: by the rules of reading, kept with the blocks, and by those on the whole tape.

use crate::diagnostic::{Diagnostic, Severity};
use crate::read::{Found, Reading};
use std::ops::Range;

/// What the rules on a whole tape found, and how much was found of each weight.
#[derive(Clone, Debug, Default)]
pub(crate) struct Findings {
    whole: Vec<Diagnostic>,
    /// The text is no tape: what reading found in it is no matter.
    foreign: bool,
    counts: [usize; 3],
}

impl Findings {
    pub(crate) fn new(whole: Vec<Diagnostic>, reading: &Reading, foreign: bool) -> Findings {
        let mut findings = Findings { whole, foreign, counts: [0; 3] };
        let own = findings.own(reading).iter().map(|found| found.diagnostic.severity);
        let mut counts = [0; 3];
        for severity in findings.whole.iter().map(|found| found.severity).chain(own) {
            counts[severity as usize] += 1;
        }
        findings.counts = counts;
        findings
    }

    /// What reading found that is said.
    fn own<'a>(&self, reading: &'a Reading) -> &'a [Found] {
        if self.foreign { &[] } else { reading.found() }
    }

    pub(crate) fn count(&self, severity: Severity) -> usize {
        self.counts[severity as usize]
    }

    /// Those that touch a stretch of the text, by position, at most `limit`. At one place those on the whole tape come
    /// first, in the order of the list of rules.
    pub(crate) fn touching(&self, reading: &Reading, range: Range<usize>, limit: usize) -> Vec<Diagnostic> {
        let touches = |place: &Range<usize>| place.start <= range.end && place.end >= range.start;
        let whole = self.whole.iter().map(|diagnostic| (0, diagnostic));
        let own = self.own(reading).iter().map(|found| (found.origin, &found.diagnostic));
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
