//! What a conversion has to say.

use super::motion::Refusal;
use crate::diagnostic::{Diagnostic, Sink};
use crate::format::Control;
use crate::function::{Miscellaneous, Preparatory, miscellaneous, preparatory};
use crate::rules::conversion as rules;
use crate::rules::skip::changes_what_follows;
use crate::tape::Tape;
use std::ops::Range;

/// Something of the tape that is not in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LeftOut {
    Preparatory(u8),
    Miscellaneous(u8),
    /// A word by its address, 0 for none.
    Word(u8),
}

impl LeftOut {
    /// The function with its meaning, or the word as written.
    pub(super) fn sentence(self, control: &Control, written: &str) -> String {
        let declared = control.format.itemized.declared.as_ref();
        let named = |name: String, assigned: Option<&str>, declared: Option<&String>| match (assigned, declared) {
            (Some(meaning), _) => format!("{name}, {meaning}"),
            (None, Some(meaning)) => format!("{name}, {meaning}"),
            (None, None) => name,
        };
        match self {
            LeftOut::Preparatory(code) => {
                let name = format!("G{code:02}");
                let assigned =
                    if let Preparatory::Assigned(_, meaning) = preparatory(code) { Some(meaning) } else { None };
                let own = declared.and_then(|declared| declared.g.get(&name));
                named(name, assigned, own)
            }
            LeftOut::Miscellaneous(code) => {
                let name = format!("M{code:02}");
                let assigned =
                    if let Miscellaneous::Assigned(.., meaning) = miscellaneous(code) { Some(meaning) } else { None };
                let own = declared.and_then(|declared| declared.m.get(&name));
                named(name, assigned, own)
            }
            LeftOut::Word(_) => written.to_owned(),
        }
    }
}

/// What was found while a tape was written.
#[derive(Default)]
pub(super) struct Findings {
    left_out: Vec<(LeftOut, Range<usize>, usize)>,
    refused: Vec<(Range<usize>, Refusal)>,
    no_feed: Vec<(Range<usize>, usize)>,
    unreached: Option<(Range<usize>, usize)>,
    intermediate: Vec<Range<usize>>,
    skips: Vec<(Range<usize>, String)>,
    chords: Option<(Range<usize>, usize, String)>,
}

impl Findings {
    pub(super) fn left_out(&mut self, what: LeftOut, range: Range<usize>) {
        match self.left_out.iter_mut().find(|(other, ..)| *other == what) {
            Some((.., count)) => *count += 1,
            None => self.left_out.push((what, range, 1)),
        }
    }

    pub(super) fn refused(&mut self, range: Range<usize>, refusal: Refusal) {
        self.refused.push((range, refusal));
    }

    pub(super) fn no_feed(&mut self, range: Range<usize>) {
        match self.no_feed.first_mut() {
            Some((_, count)) => *count += 1,
            None => self.no_feed.push((range, 1)),
        }
    }

    pub(super) fn unreached(&mut self, tape: &Tape, block: usize) {
        let range = tape.view().extent(block);
        self.unreached.get_or_insert((range, 0)).1 += 1;
    }

    pub(super) fn intermediate_end(&mut self, range: Range<usize>) {
        self.intermediate.push(range);
    }

    /// Blocks whose skipping changes what later blocks do.
    pub(super) fn skips(&mut self, tape: &Tape) {
        let view = tape.view();
        let found = changes_what_follows::changes(&view);
        self.skips = found.into_iter().map(|(block, what)| (view.extent(block), what)).collect();
    }

    /// The spans that were written as chords.
    pub(super) fn chords(&mut self, tape: &Tape, spans: &[(usize, usize)], tolerance: f64) {
        let Some((first, _)) = spans.first() else { return };
        let range = tape.view().extent(tape.spans().list[*first].blocks.0);
        let count: usize = spans.iter().map(|(_, count)| count).sum();
        let (unit, tolerance) = (tape.control().unit.name(), super::plain(tolerance));
        let said = match spans.len() {
            1 => format!("This curve is written as {count} straight cuts"),
            curves => format!("This curve and {} others are written as {count} straight cuts", curves - 1),
        };
        let message = format!(
            "{said}, at most {tolerance} {unit} off: LinuxCNC has parabolas in XY alone, and refuses arcs whose radii \
             differ by more than it allows."
        );
        self.chords = Some((range, spans.len(), message));
    }

    pub(super) fn refusals(&self) -> usize {
        self.refused.len()
    }

    pub(super) fn leaves_out(&self) -> bool {
        !self.left_out.is_empty()
    }

    pub(super) fn lacks_feed(&self) -> bool {
        !self.no_feed.is_empty()
    }

    /// All of it as diagnostics, by position.
    pub(super) fn told(self, tape: &Tape) -> Vec<Diagnostic> {
        let mut found = Vec::new();
        let mut sink = Sink::new(tape.standard(), &mut found);
        for (range, refusal) in self.refused {
            let message = match refusal {
                Refusal::Substitute => {
                    "This motion is not converted, because the tape does not say what it is: the check of the tape says \
                     why. LinuxCNC stops there. Mend the tape, or put the motion in by hand."
                }
                Refusal::Thread => {
                    "This thread is not converted: LinuxCNC cuts threads of one lead, and the tape must give it as I, J \
                     or K of its block. LinuxCNC stops there. Put the thread in by hand."
                }
                Refusal::Long => {
                    "This curve is not converted: the chords of the tape would be more than a million. LinuxCNC stops \
                     there. Convert the tape in parts."
                }
            };
            sink.report(&rules::span_not_converted::RULE, range, message.to_owned());
        }
        for (what, range, count) in self.left_out {
            let sentence = what.sentence(tape.control(), &tape.text()[range.clone()]);
            let others = match count {
                1 => " is".to_owned(),
                2 => " and one other word of this address are".to_owned(),
                _ => format!(" and {} other words of this address are", count - 1),
            };
            let (rule, message) = match what {
                LeftOut::Word(_) => (
                    &rules::word_left_out::RULE,
                    format!(
                        "{sentence}{others} left out: LinuxCNC has no such word, or the tape does not say its number. \
                         What that does on the machine is to be put in by hand, where the text says LEFT OUT."
                    ),
                ),
                _ => (
                    &rules::function_left_out::RULE,
                    format!(
                        "{sentence}, is left out: under this number LinuxCNC does something else, or its effect is not \
                         worked out here. What it does on the machine is to be put in by hand, where the text says LEFT \
                         OUT."
                    ),
                ),
            };
            sink.report(rule, range, message).count(count);
        }
        for (range, count) in self.no_feed {
            let message = "No feed is known for this cut: it is written with F0, at which LinuxCNC stops. Give the tape \
                           an F word that says one, or put the feed in by hand.";
            sink.report(&rules::cut_without_feed::RULE, range, message.to_owned()).count(count);
        }
        for (range, what) in self.skips {
            let message = format!(
                "Whether this block is skipped changes {what} for the blocks behind it. The text is right with block \
                 delete off: with it on, LinuxCNC leaves the block out, but what follows stays as it is written."
            );
            sink.report(&rules::skip_is_fixed::RULE, range, message);
        }
        for range in self.intermediate {
            let message = "Another program follows behind this end, and LinuxCNC reads no further than an end: it is \
                           written as a stop, with spindle and coolant off. Cut the text there for a file of each \
                           program.";
            sink.report(&rules::end_as_stop::RULE, range, message.to_owned());
        }
        if let Some((range, count)) = self.unreached {
            let message = "Blocks behind the end of the program are left out: no control executes them.";
            sink.report(&rules::unreached_left_out::RULE, range, message.to_owned()).count(count);
        }
        if let Some((range, count, message)) = self.chords {
            sink.report(&rules::curve_as_chords::RULE, range, message).count(count);
        }
        found.sort_by_key(|found| found.range.start);
        found
    }
}
