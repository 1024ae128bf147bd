//! What the check says: a located sentence under a rule, with related places and fixes.

use crate::format::{Format, Standard};
use crate::rules::{Rule, Verdict};
use std::ops::Range;

/// How much a diagnostic weighs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing; nothing is wrong.
    Info,
    /// A control may do something else than was meant.
    Warning,
    /// The standard forbids it.
    Error,
}

impl Severity {
    /// "error", "warning" or "info".
    pub fn name(self) -> &'static str {
        match self {
            Severity::Info => "info",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// One finding. Offsets are bytes of the text that was checked.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// The rule that it falls under.
    pub rule: &'static Rule,
    /// The rule's id under the standard in force.
    pub id: &'static str,
    /// Error, warning or info.
    pub severity: Severity,
    /// Where it is.
    pub range: Range<usize>,
    /// How often it was found, where it is said once.
    pub count: usize,
    /// What was found, what is allowed, what to do.
    pub message: String,
    /// Other places that belong to it.
    pub related: Vec<Related>,
    /// Ways to mend it.
    pub fixes: Vec<Fix>,
}

/// Another place that a diagnostic speaks of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// Where.
    pub range: Range<usize>,
    /// What is there.
    pub message: String,
}

/// A way to mend what a diagnostic found: edits of the text, or another format.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// What it does, as the words on a button.
    pub title: String,
    /// Edits of the text, in order and apart; empty where the format is to change.
    pub edits: Vec<Edit>,
    /// The format to check against instead.
    pub format: Option<Box<Format>>,
    /// The language to read the text in instead, once it is edited.
    pub language: Option<Language>,
}

/// The two languages of the playground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Language {
    /// The blocks of a tape (ISO 2539, ISO 1058, EIA RS-274).
    Tape,
    /// The records that a tape is made of (ISO 3592).
    Cldata,
}

impl Language {
    /// What a text is written in, by most of its lines. The CL text of a CAM system, which becomes CLDATA, counts as that.
    pub fn of(text: &str) -> Language {
        if crate::rules::is_source(text) { Language::Cldata } else { Language::Tape }
    }

    /// "tape" or "cldata".
    pub fn name(self) -> &'static str {
        match self {
            Language::Tape => "tape",
            Language::Cldata => "cldata",
        }
    }
}

/// Replaces a range of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What goes.
    pub range: Range<usize>,
    /// What comes in its place.
    pub insert: String,
}

impl Fix {
    /// A fix that replaces one range.
    pub fn replace(title: impl Into<String>, range: Range<usize>, insert: impl Into<String>) -> Fix {
        Fix { title: title.into(), edits: vec![Edit { range, insert: insert.into() }], format: None, language: None }
    }

    /// A fix that replaces several ranges, in order and apart.
    pub(crate) fn edits(title: impl Into<String>, edits: impl IntoIterator<Item = (Range<usize>, String)>) -> Fix {
        let edits = edits.into_iter().map(|(range, insert)| Edit { range, insert }).collect();
        Fix { title: title.into(), edits, format: None, language: None }
    }

    /// A fix that reads the text, or another one in its place, in another language.
    pub(crate) fn open_as(language: Language, title: impl Into<String>, edit: Option<(Range<usize>, String)>) -> Fix {
        Fix { language: Some(language), ..Fix::edits(title, edit) }
    }

    /// A fix that changes the format.
    pub fn reformat(title: impl Into<String>, format: Format) -> Fix {
        Fix { title: title.into(), edits: Vec::new(), format: Some(Box::new(format)), language: None }
    }
}

impl Diagnostic {
    /// The same with every place that it names moved by `by` bytes: what was said of a block becomes what is said of
    /// the tape.
    pub(crate) fn moved(&self, by: usize) -> Diagnostic {
        let mut moved = self.clone();
        moved.shift(by);
        moved
    }

    fn shift(&mut self, by: usize) {
        let shift = |range: &mut Range<usize>| *range = range.start + by..range.end + by;
        shift(&mut self.range);
        self.related.iter_mut().for_each(|related| shift(&mut related.range));
        for fix in &mut self.fixes {
            fix.edits.iter_mut().for_each(|edit| shift(&mut edit.range));
        }
    }

    /// The clauses that it rests on, under the standard in force.
    pub fn clauses(&self, standard: Standard) -> Vec<String> {
        self.rule.clauses.iter().filter_map(|clause| clause.under(standard)).collect()
    }
}

/// Takes the findings of the rules and gives each the verdict of the standard in force.
pub(crate) struct Sink<'a> {
    /// None of CLDATA, which ISO 3592 is in force for.
    standard: Option<Standard>,
    out: &'a mut Vec<Diagnostic>,
}

impl<'a> Sink<'a> {
    pub(crate) fn new(standard: Standard, out: &'a mut Vec<Diagnostic>) -> Self {
        Sink { standard: Some(standard), out }
    }

    /// For what is found in CLDATA.
    pub(crate) fn cldata(out: &'a mut Vec<Diagnostic>) -> Self {
        Sink { standard: None, out }
    }

    fn verdict(&self, rule: &Rule) -> Option<Verdict> {
        self.standard.map_or(rule.verdicts.on_cldata(), |standard| rule.verdicts.under(standard))
    }

    /// The standard in force has a verdict on what a rule looks for.
    pub(crate) fn asks(&self, rule: &Rule) -> bool {
        self.verdict(rule).is_some()
    }

    /// How many findings there are.
    pub(crate) fn len(&self) -> usize {
        self.out.len()
    }

    /// Reports a finding, unless the standard in force has no verdict on it.
    pub(crate) fn report(&mut self, rule: &'static Rule, range: Range<usize>, message: String) -> Reported<'_> {
        match self.verdict(rule) {
            Some(verdict) => self.push(rule, verdict.id, verdict.severity, range, message),
            None => Reported(None),
        }
    }

    /// Reports a finding whose weight depends on more than the standard.
    pub(crate) fn report_as(
        &mut self,
        severity: Severity,
        rule: &'static Rule,
        range: Range<usize>,
        message: String,
    ) -> Reported<'_> {
        match self.verdict(rule) {
            Some(verdict) => self.push(rule, verdict.id, severity, range, message),
            None => Reported(None),
        }
    }

    fn push(
        &mut self,
        rule: &'static Rule,
        id: &'static str,
        severity: Severity,
        range: Range<usize>,
        message: String,
    ) -> Reported<'_> {
        self.out.push(Diagnostic {
            rule,
            id,
            severity,
            range,
            count: 1,
            message,
            related: Vec::new(),
            fixes: Vec::new(),
        });
        Reported(self.out.last_mut())
    }
}

/// A finding just reported, to which places and fixes can be added; nothing where the standard has no verdict.
pub(crate) struct Reported<'a>(Option<&'a mut Diagnostic>);

impl Reported<'_> {
    pub(crate) fn count(self, count: usize) -> Self {
        self.with(|d| d.count = count)
    }

    pub(crate) fn related(self, range: Range<usize>, message: impl Into<String>) -> Self {
        self.with(|d| d.related.push(Related { range, message: message.into() }))
    }

    pub(crate) fn fix(self, fix: impl FnOnce() -> Fix) -> Self {
        self.with(|d| d.fixes.push(fix()))
    }

    pub(crate) fn fixes(self, fixes: impl IntoIterator<Item = Fix>) -> Self {
        self.with(|d| d.fixes.extend(fixes))
    }

    fn with(mut self, change: impl FnOnce(&mut Diagnostic)) -> Self {
        if let Some(diagnostic) = self.0.as_deref_mut() {
            change(diagnostic);
        }
        self
    }
}
