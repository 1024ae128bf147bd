//! A report as a script sees it.

use crate::offsets::Offsets;
use crate::value::Plain;
use nctape::read::Block;
use nctape::span::{Geometry, Spans};
use nctape::{Diagnostic, Language, ROW_PITCH_MILLIMETRES, Standard, Tape};
use serde::Serialize;
use std::ops::Range;

/// The version of the interface.
pub(crate) const API: u32 = 1;

#[derive(Serialize)]
pub(crate) struct ReportView {
    pub api: u32,
    pub unit: &'static str,
    pub axes: Vec<String>,
    pub diagnostics: Vec<DiagnosticView>,
    pub suppressed: usize,
    pub blocks: Vec<BlockView>,
    pub spans: Vec<SpanView>,
    pub totals: TotalsView,
}

#[derive(Serialize)]
pub(crate) struct DiagnosticView {
    rule: &'static str,
    name: &'static str,
    severity: &'static str,
    from: usize,
    to: usize,
    line: usize,
    column: usize,
    count: usize,
    message: String,
    clauses: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related: Vec<RelatedView>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    fixes: Vec<FixView>,
    /// The field of a format that it speaks of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<String>,
}

#[derive(Serialize)]
struct RelatedView {
    from: usize,
    to: usize,
    message: String,
}

#[derive(Serialize)]
struct FixView {
    title: String,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    edits: Vec<EditView>,
    #[serde(skip_serializing_if = "Option::is_none")]
    format: Option<Plain>,
    #[serde(skip_serializing_if = "Option::is_none")]
    kind: Option<&'static str>,
}

#[derive(Serialize)]
struct EditView {
    from: usize,
    to: usize,
    insert: String,
}

#[derive(Serialize)]
pub(crate) struct BlockView {
    pub from: usize,
    pub to: usize,
    pub sequence: Option<String>,
    pub words: Vec<WordView>,
}

#[derive(Serialize)]
pub(crate) struct WordView {
    pub address: String,
    pub from: usize,
    pub to: usize,
    pub value: Option<f64>,
}

#[derive(Serialize)]
pub(crate) struct SpanView {
    kind: &'static str,
    blocks: (usize, usize),
    start: Vec<f64>,
    end: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    plane: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    centre: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sweep: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tangent: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    control: Option<[[f64; 3]; 2]>,
    length: f64,
    feed: Option<f64>,
    seconds: Option<f64>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    substitute: bool,
}

#[derive(Serialize)]
pub(crate) struct TotalsView {
    pub rows: usize,
    #[serde(rename = "tapeMillimetres")]
    pub tape_millimetres: f64,
    pub cutting: f64,
    pub rapid: f64,
    pub seconds: Option<f64>,
}

/// The axes of a tape by letter.
pub(crate) fn axes(tape: &Tape) -> Vec<String> {
    tape.control().axes.iter().map(|axis| axis.letter.to_string()).collect()
}

/// A diagnostic about a text.
pub(crate) fn diagnostic(found: &Diagnostic, standard: Standard, offsets: &Offsets) -> DiagnosticView {
    let units = |range: &Range<usize>| (offsets.utf16(range.start), offsets.utf16(range.end));
    let (from, to) = units(&found.range);
    let (line, column) = offsets.line_column(from);
    let related = found.related.iter().map(|related| {
        let (from, to) = units(&related.range);
        RelatedView { from, to, message: related.message.clone() }
    });
    let fixes = found.fixes.iter().map(|fix| {
        let edits = fix.edits.iter().map(|edit| {
            let (from, to) = units(&edit.range);
            EditView { from, to, insert: edit.insert.clone() }
        });
        let format = fix.format.as_ref().map(|format| Plain(format.write()));
        let kind = fix.language.map(Language::name);
        FixView { title: fix.title.clone(), edits: edits.collect(), format, kind }
    });
    DiagnosticView {
        rule: found.id,
        name: found.rule.name,
        severity: found.severity.name(),
        from,
        to,
        line,
        column,
        count: found.count,
        message: found.message.clone(),
        clauses: found.clauses(standard),
        related: related.collect(),
        fixes: fixes.collect(),
        path: None,
    }
}

/// A block with its words.
pub(crate) fn block(tape: &Tape, block: &Block, offsets: &Offsets) -> BlockView {
    let words = tape.reading().words(block).iter().map(|word| {
        let range = tape.reading().range(block, word);
        WordView {
            address: if word.address == 0 { String::new() } else { word.letter().to_string() },
            from: offsets.utf16(range.start),
            to: offsets.utf16(range.end),
            value: tape.value(word),
        }
    });
    BlockView {
        from: offsets.utf16(block.range.start),
        to: offsets.utf16(block.range.end),
        sequence: tape.sequence(block),
        words: words.collect(),
    }
}

/// A span with every axis at its ends.
pub(crate) fn span(tape: &Tape, index: usize) -> SpanView {
    span_of(tape.spans(), index)
}

/// The same, of any spans.
pub(crate) fn span_of(spans: &Spans, index: usize) -> SpanView {
    let span = &spans.list[index];
    let mut view = SpanView {
        kind: span.kind.name(),
        blocks: span.blocks,
        start: spans.start(index),
        end: spans.end(index),
        plane: None,
        centre: None,
        sweep: None,
        tangent: None,
        control: None,
        length: span.length,
        feed: span.feed,
        seconds: span.seconds,
        substitute: span.substitute,
    };
    match span.geometry {
        Geometry::Line => {}
        Geometry::Arc(arc) => {
            let [first, second, third] = arc.plane.axes();
            let mut centre = vec![0.0; 3];
            centre[first] = arc.centre[0];
            centre[second] = arc.centre[1];
            centre[third] = span.start[third];
            view.plane = Some(arc.plane.word());
            view.centre = Some(centre);
            view.sweep = Some(arc.sweep);
        }
        Geometry::Parabola { tangent } => view.tangent = Some(tangent.to_vec()),
        Geometry::Curve { control } => view.control = Some(control),
    }
    view
}

/// Lengths and times.
pub(crate) fn totals(tape: &Tape) -> TotalsView {
    let rows = tape.reading().row_count();
    let totals = tape.totals();
    TotalsView {
        rows,
        tape_millimetres: rows as f64 * ROW_PITCH_MILLIMETRES,
        cutting: totals.cutting,
        rapid: totals.rapid,
        seconds: totals.seconds.filter(|seconds| seconds.is_finite()),
    }
}
