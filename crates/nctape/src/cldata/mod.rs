//! CLDATA: the reference language of ISO 3592, from a text to records, spans and diagnostics.
//!
//! ```text
//! text ─► elements ─► records ─► files ─► spans
//!              └─────────┴─────────┴────────┴─► diagnostics
//! ```
//!
//! ```
//! use nctape::cldata::{Cldata, Options};
//!
//! let text = "1,20000,0,PARTNO,'PLATE';\n2,5000,3,'',0,.,.,10.;\n3,5000,5,'',0,30.,40.,10.;\n4,14000;\n:\n";
//! let cldata = Cldata::new(text, &Options::default());
//! assert_eq!(cldata.records().len(), 4);
//! assert_eq!(cldata.spans().list[0].length, 50.0);
//! ```

pub mod apt;
mod characters;
mod circle;
pub(crate) mod command;
mod element;
pub(crate) mod event;
pub(crate) mod execution;
mod held;
mod links;
mod literal;
mod motion;
mod number;
mod reader;
pub(crate) mod record;
mod says;
mod scan;
mod shape;
pub(crate) mod step;
mod stream;
mod word_table;
mod words;

pub use element::{Element, ElementKind};
pub use held::{Held, Register};
pub use record::{Record, type_name};
pub use words::{Coded, Dialect, Key, Part, decode, nearest};

use crate::diagnostic::{Diagnostic, Severity};
use crate::execute::{Bounds, Totals};
use crate::flatten::{Points, flatten};
use crate::format::Unit;
use crate::rules::{CldataView, check_cldata};
use crate::span::Spans;
use execution::{Execution, execute};
use record::Tables;
use std::borrow::Cow;
use std::ops::Range;
use step::Step;
use stream::Stream;

/// How a text is to be read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Read as records of so many columns (annex A), 1 to 1000; otherwise as a stream. Text behind the last column is
    /// not of the language.
    pub columns: Option<usize>,
    /// Whose table of integer codes holds in records of type 2000; otherwise what most systems have.
    pub dialect: Option<Dialect>,
}

/// A text of CLDATA, and all that follows from it. Any text gives one.
#[derive(Clone, Debug)]
pub struct Cldata {
    text: String,
    /// The filled columns, where the text is read so, with their places.
    stream: Stream<'static>,
    columns: Option<usize>,
    dialect: Option<Dialect>,
    tables: Tables,
    execution: Execution,
    diagnostics: Vec<Diagnostic>,
}

/// The statement of a part program from which a record comes (6.2).
#[derive(Clone, Debug, PartialEq)]
pub struct Statement<'a> {
    /// The record that identifies it.
    pub record: usize,
    /// Its number in the part program.
    pub number: Option<i64>,
    /// Its identification, as in columns 73 to 80 of a card.
    pub identification: Cow<'a, str>,
    /// The statement itself, where the record carries it.
    pub text: Option<Cow<'a, str>>,
}

impl Cldata {
    /// Reads, executes and checks a text.
    pub fn new(text: &str, options: &Options) -> Cldata {
        Cldata::read(text, options, false)
    }

    /// The same, with every step kept: see [`Cldata::steps`].
    pub(crate) fn with_steps(text: &str, options: &Options) -> Cldata {
        Cldata::read(text, options, true)
    }

    fn read(text: &str, options: &Options, keeps: bool) -> Cldata {
        let columns = options.columns.map(|columns| columns.clamp(1, 1000));
        let text = text.to_owned();
        let mut stream = match columns {
            None => Stream::of_text(&text),
            Some(columns) => Stream::of_columns(&text, columns),
        };
        let foreign = crate::rules::source_of_apt(&text);
        let tables = if foreign.is_some() { Tables::default() } else { reader::read(&stream) };
        let execution = execute(&tables, options.dialect, keeps);
        let view = CldataView { text: &stream.text, tables: &tables, execution: &execution };
        let mut diagnostics = check_cldata(&view, foreign);
        if let Some(columns) = columns {
            place(&mut diagnostics, &stream, &text, columns);
        }
        // A stream of the text itself is not kept twice.
        let stream = match columns {
            None => Stream::default(),
            Some(_) => std::mem::take(&mut stream).into_owned(),
        };
        Cldata { text, stream, columns, dialect: options.dialect, tables, execution, diagnostics }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The records of all files.
    pub fn records(&self) -> &[Record] {
        &self.tables.records
    }

    /// How many files there are.
    pub fn files(&self) -> usize {
        self.tables.files.len()
    }

    /// The elements of a record.
    pub fn elements(&self, record: &Record) -> &[Element] {
        self.tables.of(record)
    }

    /// Where a record is in the text, its separator included.
    pub fn record_range(&self, record: &Record) -> Range<usize> {
        self.in_text(record.range())
    }

    /// Where an element is in the text.
    pub fn element_range(&self, element: &Element) -> Range<usize> {
        self.in_text(element.range())
    }

    fn in_text(&self, range: Range<usize>) -> Range<usize> {
        if self.columns.is_some() { self.stream.range_in_text(&range) } else { range }
    }

    /// The characters of a literal: without its apostrophes, a doubled one being one. `None` of any other element.
    pub fn literal(&self, element: &Element) -> Option<Cow<'_, str>> {
        if element.kind != ElementKind::Literal {
            return None;
        }
        let stream = if self.columns.is_some() { &*self.stream.text } else { &self.text };
        Some(literal_text(&stream[element.range()]))
    }

    /// The letters of a keyword, in capital letters; empty of any other element.
    pub fn keyword(&self, element: &Element) -> String {
        if element.kind != ElementKind::Keyword {
            return String::new();
        }
        let stream = if self.columns.is_some() { &*self.stream.text } else { &self.text };
        let letters = stream[element.range()].chars().filter(char::is_ascii_alphabetic);
        letters.map(|letter| letter.to_ascii_uppercase()).collect()
    }

    /// The statement from which a record comes.
    pub fn statement(&self, record: usize) -> Option<Statement<'_>> {
        let file = self.tables.records.get(record)?.file;
        let before = self.tables.records[..=record].iter().enumerate().rev();
        let mut before = before.take_while(|(_, before)| before.file == file);
        let (index, found) = before.find(|(_, before)| before.kind == 1000)?;
        let elements = self.tables.of(found);
        Some(Statement {
            record: index,
            number: elements.get(2).and_then(Element::whole),
            identification: elements.get(3).and_then(|element| self.literal(element)).unwrap_or_default(),
            text: elements.get(4).and_then(|element| self.literal(element)),
        })
    }

    /// What the records say one after the other; nothing where no steps were kept.
    pub(crate) fn steps(&self) -> &[Step] {
        &self.execution.steps
    }

    /// The records of each file.
    pub(crate) fn file_records(&self) -> impl Iterator<Item = Range<usize>> {
        self.tables.file_records()
    }

    /// The greatest tolerance that the text states (INTOL, OUTTOL), zero where it states none; in its unit.
    pub(crate) fn tolerance(&self) -> f64 {
        self.execution.tolerance
    }

    /// All elements of all records.
    pub(crate) fn all_elements(&self) -> &[Element] {
        &self.tables.elements
    }

    /// The path. The blocks of a span are records.
    pub fn spans(&self) -> &Spans {
        &self.execution.spans
    }

    /// The unit of lengths: that of the first file that says one, millimetres where none does. Centimetres are given
    /// in millimetres, feet in inches.
    pub fn unit(&self) -> Unit {
        self.execution.unit
    }

    /// What was found, by position.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// How many findings of a weight there are.
    pub fn count(&self, severity: Severity) -> usize {
        self.diagnostics.iter().filter(|found| found.severity == severity).count()
    }

    /// Lengths and times.
    pub fn totals(&self) -> Totals {
        Totals::of(self.spans().shares())
    }

    /// The smallest box around the path.
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(&self.spans().list)
    }

    /// The path as points: no point of a curve is further from its polyline than `tolerance`, a positive length in the
    /// unit of [`Cldata::unit`].
    pub fn points(&self, tolerance: f64) -> Points {
        flatten(&self.spans().list, 0..self.spans().list.len(), tolerance)
    }
}

/// The characters between the apostrophes of a literal; the second one may be missing.
fn literal_text(written: &str) -> Cow<'_, str> {
    let mut characters = written.chars();
    let opening = characters.next().unwrap_or('\'');
    let inside = characters.as_str();
    let closes = |character: char| character == '\'' || opening != '\'' && characters::is_quote(character);
    // An odd number of apostrophes at the end: the last one closes.
    let at_end = inside.chars().rev().take_while(|character| closes(*character)).count();
    let inside = match inside.char_indices().next_back() {
        Some((at, _)) if at_end % 2 == 1 => &inside[..at],
        _ => inside,
    };
    if !inside.contains(closes) {
        return Cow::Borrowed(inside);
    }
    let mut text = String::new();
    let mut doubled = false;
    for character in inside.chars() {
        if closes(character) {
            doubled = !doubled;
            if doubled {
                text.push('\'');
            }
        } else {
            doubled = false;
            text.push(character);
        }
    }
    Cow::Owned(text)
}

/// Brings what was found in the stream to the places of the text. A fix that would push characters over the last column
/// is none.
fn place(diagnostics: &mut [Diagnostic], stream: &Stream<'_>, text: &str, columns: usize) {
    for found in diagnostics {
        found.range = stream.range_in_text(&found.range);
        for related in &mut found.related {
            related.range = stream.range_in_text(&related.range);
        }
        found.fixes.retain_mut(|fix| {
            fix.edits.iter_mut().all(|edit| {
                edit.range = stream.range_in_text(&edit.range);
                let longer = edit.insert.chars().count().saturating_sub(text[edit.range.clone()].chars().count());
                longer <= stream.room(edit.range.start, text, columns)
            })
        });
    }
}
