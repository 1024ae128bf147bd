//! Piece by piece: heads and blocks, one behind the other.

use super::block::{Block, Traits};
use super::head::{Head, read_head};
use super::scanner::{BlockEnd, scan};
use super::word::Word;
use super::{BlockView, Stray};
use crate::diagnostic::{Diagnostic, Sink};
use crate::format::Control;
use crate::rules::{self, word};
use crate::text::Listing;

/// A finding of the rules of reading. The diagnostic counts from `origin`, the start of the piece that it is about, so
/// that it stays true when the text before it changes.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub origin: usize,
    pub diagnostic: Diagnostic,
}

/// What was read, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct Pieces {
    pub heads: Vec<Head>,
    pub blocks: Vec<Block>,
    pub found: Vec<Found>,
}

/// What may stand at a place of the text: the lexical state there. In a comment no piece begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    Head,
    Block,
}

/// Reads one piece after the other. How a piece is read hangs on nothing but the text from its start on and the control.
pub(super) struct Reader<'a> {
    pub text: &'a str,
    pub control: &'a Control,
    /// The words of all blocks: those that are read are added.
    pub words: &'a mut Vec<Word>,
    pub pieces: Pieces,
    /// Where the next piece begins, and what it is; `None` behind the last one.
    pub at: usize,
    pub place: Option<Place>,
    /// Rows, blocks and program start characters before it.
    pub row: usize,
    pub blocks: usize,
    pub program: u32,
    /// The text ends in a comment that nothing closes.
    pub open_comment: bool,
    strays: Vec<Stray>,
    fresh: Vec<Diagnostic>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(text: &'a str, control: &'a Control, words: &'a mut Vec<Word>) -> Reader<'a> {
        Reader {
            text,
            control,
            words,
            pieces: Pieces::default(),
            at: 0,
            place: Some(Place::Head),
            row: 0,
            blocks: 0,
            program: 0,
            open_comment: false,
            strays: Vec::new(),
            fresh: Vec::new(),
        }
    }

    /// Reads the next piece.
    pub(super) fn read(&mut self) {
        match self.place {
            Some(Place::Head) => self.read_head(),
            Some(Place::Block) => self.read_block(),
            None => {}
        }
    }

    fn read_head(&mut self) {
        let start = self.at;
        self.strays.clear();
        let head = read_head(self.text, start, self.control, &mut self.strays);
        let code = self.control.code;
        let characters = Listing::resume(self.text, start, false).take_while(|it| it.from < head.end);
        let rows = characters.filter(|it| it.has_row(code)).count();
        self.program += u32::from(head.mark.is_some());
        self.pieces.heads.push(Head {
            start,
            row: self.row,
            mark: head.mark,
            led: head.led,
            looked: head.looked,
            blocks_before: self.blocks,
            program: self.program,
        });
        rules::check_head(&self.strays, self.control, &mut Sink::new(self.control.standard(), &mut self.fresh));
        self.keep_findings(start);
        self.at = head.end;
        self.row += rows;
        self.place = Some(Place::Block);
    }

    fn read_block(&mut self) {
        let start = self.at;
        let first_word = self.words.len();
        self.strays.clear();
        let scanned = scan(self.text, start, self.control, self.words, &mut self.strays);
        let words = &self.words[first_word..];
        let characters = &self.text[start..scanned.next];
        let ended = matches!(scanned.end, BlockEnd::EndOfBlock(_));
        let bare = self.strays.is_empty() && scanned.skip.is_none() && !scanned.comment;
        // Layout before a program start character or the end of the text is no block and has no faults.
        let layout = !ended
            && words.is_empty()
            && bare
            && (scanned.end == BlockEnd::ProgramStart || characters.trim().is_empty());
        if !layout {
            let view = BlockView {
                control: self.control,
                text: characters,
                words,
                strays: &self.strays,
                skip: scanned.skip,
                comment: scanned.comment,
                tab: scanned.tab,
                end: match scanned.end {
                    BlockEnd::EndOfBlock(byte) => Some(byte - start),
                    _ => None,
                },
            };
            rules::check_block(&view, &mut Sink::new(self.control.standard(), &mut self.fresh));
        }
        // What follows the last end of block without a word is no block: a comment, or layout.
        if !words.is_empty() || ended {
            let at = first_word as u32..self.words.len() as u32;
            let tab = if scanned.tab { Traits::TAB } else { Traits::default() };
            let places = word::wants_look(words, self.control);
            let traits = if places { tab.with(Traits::FEED_PLACES) } else { tab };
            let block = Block::new(start..scanned.next, words, at, traits);
            let (skip, program, row, rows) = (scanned.skip.is_some(), self.program, self.row, scanned.rows);
            self.pieces.blocks.push(Block { skip, program, row, rows, ..block });
            self.blocks += 1;
        }
        self.keep_findings(start);
        self.at = scanned.next;
        self.row += scanned.rows;
        self.place = match scanned.end {
            BlockEnd::EndOfBlock(_) => Some(Place::Block),
            BlockEnd::ProgramStart => Some(Place::Head),
            BlockEnd::Text => {
                self.open_comment = scanned.unclosed;
                None
            }
        };
    }

    fn keep_findings(&mut self, origin: usize) {
        // Stable: at one place the order is that of the lists of rules.
        self.fresh.sort_by_key(|found| (found.range.start, found.range.end));
        self.pieces.found.extend(self.fresh.drain(..).map(|diagnostic| Found { origin, diagnostic }));
    }
}
