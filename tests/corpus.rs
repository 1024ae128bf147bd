//! Whole tapes of realistic size, sound ones and faulty ones, with all that is said of them.
//!
//! Each tape `tests/corpus/{good,bad}/<name>.tape` stands beside its format, `<name>.json`, and its report,
//! `<name>.report`: the diagnostics, then what was read and executed. The presets have reports too. `BLESS=1 cargo test -p nctape --test corpus`
//! writes the reports anew; read them line by line before you commit.

use nctape::format::explain;
use nctape::format::value::Value;
use nctape::span::SpanKind;
use nctape::{Diagnostic, Format, Severity, Tape, presets};
use std::fmt::Write;
use std::path::{Path, PathBuf};

#[path = "support/json.rs"]
mod json;

/// The tapes of one folder, by name.
fn tapes(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus").join(folder);
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut tapes: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|end| end == "tape")).collect();
    tapes.sort();
    tapes
}

fn check(folder: &str, sound: impl Fn(&[&Diagnostic]) -> Result<(), String>) {
    let mut faults = Vec::new();
    for path in tapes(folder) {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let text = std::fs::read_to_string(&path).unwrap();
        let specification = std::fs::read_to_string(path.with_extension("json")).expect("a format beside the tape");
        let value: Value = json::read(&specification).expect("JSON");
        let (format, problems) = Format::read(&value).expect("a format");
        assert!(problems.is_empty(), "{name}.json: {problems:?}");
        let found = report(&text, &format);
        let tape = Tape::new(&text, &format);
        if let Err(fault) = sound(&tape.diagnostics().iter().collect::<Vec<_>>()) {
            faults.push(format!("{name}: {fault}\n{found}"));
        }
        faults.extend(compare(&path.with_extension("report"), &found));
    }
    assert!(faults.is_empty(), "\n\n{}", faults.join("\n"));
}

/// What is wrong with a report, against the one that was blessed.
fn compare(file: &Path, found: &str) -> Option<String> {
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(file, found).unwrap();
    }
    let blessed = std::fs::read_to_string(file).unwrap_or_default();
    (blessed != found).then(|| format!("{}: the report is now\n{found}", file.display()))
}

#[test]
fn the_presets() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/presets");
    let file = |id: &str| folder.join(id).with_extension("report");
    let faults: Vec<String> = presets::tapes()
        .iter()
        .filter_map(|preset| compare(&file(preset.id), &report(preset.source, &preset.format)))
        .collect();
    assert!(faults.is_empty(), "\n\n{}", faults.join("\n"));
}

#[test]
fn good_tapes_have_no_error_and_no_warning() {
    check("good", |found| match found.iter().find(|found| found.severity > Severity::Info) {
        Some(found) => Err(format!("{} in a good tape", found.id)),
        None => Ok(()),
    });
}

#[test]
fn bad_tapes_have_an_error_or_a_warning() {
    check("bad", |found| match found.iter().any(|found| found.severity > Severity::Info) {
        true => Ok(()),
        false => Err("nothing is found".to_owned()),
    });
}

/// All that is said of a tape, for people to read.
fn report(text: &str, format: &Format) -> String {
    let mut out = String::new();
    for found in explain(format).diagnostics {
        let diagnostic = found.diagnostic;
        writeln!(
            out,
            "format: {} {} {}: {}",
            diagnostic.severity.name(),
            diagnostic.id,
            found.path,
            diagnostic.message
        )
        .unwrap();
    }
    let tape = Tape::new(text, format);
    for found in tape.diagnostics() {
        let from = place(text, found.range.start);
        let to = place(text, found.range.end);
        let end = if from.0 == to.0 { to.1.to_string() } else { format!("{}:{}", to.0, to.1) };
        let count = if found.count > 1 { format!(" ({} times)", found.count) } else { String::new() };
        let (severity, id, message) = (found.severity.name(), found.id, &found.message);
        writeln!(out, "{severity} {id} {}:{}-{end}{count}: {message}", from.0, from.1).unwrap();
        for related in &found.related {
            let (line, column) = place(text, related.range.start);
            writeln!(out, "    {line}:{column}: {}", related.message).unwrap();
        }
        for fix in &found.fixes {
            writeln!(out, "    fix: {}", fix.title).unwrap();
        }
    }
    if !out.is_empty() {
        out.push('\n');
    }
    let (reading, spans) = (tape.reading(), tape.spans());
    let kinds = [SpanKind::Rapid, SpanKind::Line, SpanKind::Arc, SpanKind::Parabola, SpanKind::Curve, SpanKind::Dwell];
    let counts: Vec<String> = kinds
        .iter()
        .map(|kind| (spans.list.iter().filter(|span| span.kind == *kind).count(), kind.name()))
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| format!("{count} {name}"))
        .collect();
    writeln!(out, "blocks: {}, words: {}", reading.blocks.len(), reading.word_count()).unwrap();
    writeln!(out, "spans: {}", if counts.is_empty() { "none".to_owned() } else { counts.join(", ") }).unwrap();
    if let Some(last) = spans.list.len().checked_sub(1) {
        let end: Vec<String> = spans.end(last).iter().map(|value| format!("{value:.4}")).collect();
        writeln!(out, "end: {}", end.join(" ")).unwrap();
    }
    let totals = tape.totals();
    let seconds = totals.seconds.map_or("unknown".to_owned(), |seconds| format!("{seconds:.2}"));
    writeln!(out, "cutting: {:.4}, rapid: {:.4}, seconds: {seconds}", totals.cutting, totals.rapid).unwrap();
    writeln!(out, "rows: {}", tape.rows().bytes.len()).unwrap();
    out
}

/// Line and column of a byte, both from 1; columns are characters. CR LF and a lone CR end a line too.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = &text[..at];
    let ends = before.char_indices().filter(|&(at, c)| c == '\n' || c == '\r' && !text[at + 1..].starts_with('\n'));
    let (lines, from) = ends.fold((1, 0), |(lines, _), (at, _)| (lines + 1, at + 1));
    (lines, before[from..].chars().count() + 1)
}
