//! Words as blocks: their order, tabs, sequence numbers, skip and comments.

use super::TapeWriter;
use crate::format::System;

/// A block as it was written, so that it can be written anew with one more word.
pub(super) struct Last {
    start: usize,
    words: Vec<(char, String)>,
    remarks: String,
    skip: bool,
}

impl TapeWriter<'_> {
    /// The next block has this word, too.
    pub(crate) fn hold(&mut self, address: char, word: String) {
        self.held.push((address, word));
    }

    /// Writes the words that no block has taken, as a block of their own.
    pub(crate) fn flush(&mut self) {
        // A function that acts in its block alone does so without a motion, too.
        if let Some(word) = self.once.take().and_then(|code| self.code_word('G', i64::from(code)).ok()) {
            self.held.push(('G', word));
        }
        if !self.held.is_empty() {
            self.block(Vec::new());
        }
    }

    /// The next block is one at which a machine may begin (the alignment function): it says all that is in force.
    pub(crate) fn align(&mut self) {
        self.align = true;
        self.forget();
    }

    /// Adds a word to the block written last, if that begins at byte `from` or behind it and has none of this address;
    /// else the word is a block of its own.
    pub(crate) fn append(&mut self, address: char, word: String, from: usize) {
        let fits = |last: &mut Last| last.start >= from && last.words.iter().all(|(other, _)| *other != address);
        match self.last.take_if(fits) {
            Some(mut last) => {
                self.text.truncate(last.start);
                last.words.push((address, word));
                self.put(last);
            }
            None => self.block(vec![(address, word)]),
        }
    }

    /// Writes a block of words, at most one of each address, in the order of the detail.
    pub(super) fn block(&mut self, mut words: Vec<(char, String)>) {
        for (address, word) in std::mem::take(&mut self.held) {
            match words.iter().any(|(other, _)| *other == address) {
                true => self.separate((address, word)),
                false => words.push((address, word)),
            }
        }
        self.numbered(words);
    }

    /// Writes a block of one word before the one that holds others.
    pub(super) fn separate(&mut self, word: (char, String)) {
        self.numbered(vec![word]);
    }

    fn numbered(&mut self, mut words: Vec<(char, String)>) {
        if let Some(designation) = self.control.designation(b'N').filter(|_| self.numbering.on) {
            let most = 10_i64.pow(u32::from(designation.width().clamp(1, 18))) - 1;
            let numbering = &mut self.numbering;
            if numbering.next > most {
                self.wrapped = true;
                numbering.next = numbering.first.min(most);
            }
            let number = format!("{:0width$}", numbering.next, width = usize::from(designation.width()));
            numbering.next = numbering.next.saturating_add(numbering.step);
            words.push((if std::mem::take(&mut self.align) { ':' } else { 'N' }, number));
        }
        let remarks = std::mem::take(&mut self.remarks);
        self.put(Last { start: self.text.len(), words, remarks, skip: self.skip });
    }

    fn put(&mut self, block: Last) {
        if block.skip {
            self.text.push('/');
        }
        let columns = self.control.system == System::Tab;
        let (mut tabs, mut first) = (0, true);
        for designation in &self.control.detail.words {
            tabs += usize::from(designation.tab);
            let is = |address: char| address == designation.address || address == ':' && designation.address == 'N';
            let Some((address, word)) = block.words.iter().find(|(address, _)| is(*address)) else { continue };
            if tabs > 0 {
                self.text.extend(std::iter::repeat_n('\t', tabs));
            } else if !first {
                self.text.push(' ');
            }
            (tabs, first) = (0, false);
            // The alignment character takes the place of an address that the column would tell.
            if !columns || *address == ':' {
                let lower = self.control.standard() == crate::Standard::Rs274;
                self.text.push(if lower { address.to_ascii_lowercase() } else { *address });
            }
            self.text.push_str(word);
        }
        self.text.push_str(&block.remarks);
        self.text.push('\n');
        self.last = Some(block);
    }

    /// Comments that no block is left for stand behind the last one.
    pub(crate) fn finish(&mut self) {
        self.flush();
        let remarks = std::mem::take(&mut self.remarks);
        if !remarks.is_empty() && self.text.ends_with('\n') {
            self.text.insert_str(self.text.len() - 1, &remarks);
        }
    }
}
