//! What is posted: the reference language, and how its records lead back to the text as given.

use crate::cldata::{Cldata, Options, apt};
use std::ops::Range;

/// A text that is posted.
pub(super) struct Source {
    pub cldata: Cldata,
    /// Of CL text: from each statement to its records.
    statements: Option<Vec<(Range<usize>, Range<usize>)>>,
    /// The statements of CL text that became no command.
    pub faults: Vec<apt::Fault>,
}

impl Source {
    pub(super) fn read(text: &str, options: &Options) -> Source {
        if !apt::is_cl_text(text) {
            return Source { cldata: Cldata::with_steps(text, options), statements: None, faults: Vec::new() };
        }
        let translated = apt::translate(text);
        // What the translation writes is a stream, whatever the columns of the reference language are.
        let reading = Options { columns: None, ..*options };
        Source {
            cldata: Cldata::with_steps(&translated.text, &reading),
            statements: Some(translated.map),
            faults: translated.faults,
        }
    }

    /// What was read, where that is the text as given.
    pub(super) fn into_cldata(self) -> Option<Cldata> {
        self.statements.is_none().then_some(self.cldata)
    }

    /// A record in the text as given.
    pub(super) fn record(&self, record: usize) -> Range<usize> {
        self.given(self.cldata.record_range(&self.cldata.records()[record]))
    }

    /// Some elements in the text as given, by their places in the table of all.
    pub(super) fn elements(&self, elements: Range<usize>) -> Range<usize> {
        let all = self.cldata.all_elements();
        let [first, last] = [elements.start, elements.end.max(elements.start + 1) - 1].map(|at| all.get(at));
        let (Some(first), Some(last)) = (first, last) else { return 0..0 };
        let (first, last) = (self.cldata.element_range(first), self.cldata.element_range(last));
        self.given(first.start..last.end.max(first.end))
    }

    /// The characters of the literals behind the word of a command.
    pub(super) fn literals(&self, record: usize) -> String {
        let record = &self.cldata.records()[record];
        let texts = self.cldata.elements(record).iter().filter_map(|element| self.cldata.literal(element));
        texts.collect::<Vec<_>>().join(" ")
    }

    /// A place in the reference language is that of its statement in CL text.
    fn given(&self, range: Range<usize>) -> Range<usize> {
        let Some(statements) = &self.statements else { return range };
        let index = statements.partition_point(|(_, records)| records.end <= range.start);
        statements.get(index).map_or(0..0, |(statement, _)| statement.clone())
    }

    /// The map as its reader sees it: the records of one statement together.
    pub(super) fn joined(&self, map: Vec<(Range<usize>, Range<usize>)>) -> Vec<(Range<usize>, Range<usize>)> {
        if self.statements.is_none() {
            return map;
        }
        let mut joined: Vec<(Range<usize>, Range<usize>)> = Vec::new();
        for (source, text) in map {
            match joined.last_mut() {
                // Records of a statement follow one another, and the first ones often give nothing.
                Some((before, blocks)) if *before == source && blocks.end == text.start => blocks.end = text.end,
                _ => joined.push((source, text)),
            }
        }
        joined
    }
}
