//! A rule page taken apart: its title and the examples in its fences.

use nctape::Format;
use nctape::format::FormatDiagnostic;
use std::ops::Range;

#[path = "json.rs"]
mod json;

/// A page.
pub struct Page {
    /// The first line without its `# `.
    pub title: String,
    /// Tapes with the formats that they are run under.
    pub tapes: Vec<TapeExample>,
    /// Formats that are themselves the example.
    pub formats: Vec<FormatExample>,
    /// CLDATA.
    pub cldata: Vec<CldataExample>,
}

/// CLDATA in a fence ` ```cldata bad ` or ` ```cldata good `.
pub struct CldataExample {
    /// The line of the page on which its fence begins.
    pub line: usize,
    /// The caret lines taken out.
    pub text: String,
    /// What the caret lines mark; none in a good example.
    pub marks: Vec<Mark>,
}

/// A tape in a fence ` ```tape bad ` or ` ```tape good `, or CLDATA behind a format, which is posted.
pub struct TapeExample {
    /// The line of the page on which its fence begins.
    pub line: usize,
    /// The caret lines taken out.
    pub text: String,
    /// What the caret lines mark; none in a good example.
    pub marks: Vec<Mark>,
    /// It shows the fault.
    pub bad: bool,
    /// It is CLDATA.
    pub cldata: bool,
    /// The formats of its group.
    pub formats: Vec<FormatExample>,
}

/// A place that a caret line marks, in bytes of the tape.
pub struct Mark {
    /// From the first to the last caret.
    pub range: Range<usize>,
    /// Where the marked line ends, its end of block not counted.
    pub line_end: usize,
}

/// A format in a fence ` ```json … `.
#[derive(Clone)]
pub struct FormatExample {
    /// The line of the page on which its fence begins.
    pub line: usize,
    /// As it was read.
    pub format: Format,
    /// What reading it found.
    pub problems: Vec<FormatDiagnostic>,
    /// The path of the field and the text in it at fault; `None` in a good example.
    pub fault: Option<(String, String)>,
}

struct Fence<'a> {
    line: usize,
    info: &'a str,
    body: &'a str,
}

impl Page {
    /// Takes a page apart; what cannot be understood is an error with its line.
    pub fn read(markdown: &str) -> Result<Page, String> {
        let title = markdown.lines().next().and_then(|line| line.strip_prefix("# ")).unwrap_or("").to_owned();
        let mut page = Page { title, tapes: Vec::new(), formats: Vec::new(), cldata: Vec::new() };
        let mut group: Vec<FormatExample> = Vec::new();
        let mut group_is_used = false;
        for fence in fences(markdown)? {
            let line = fence.line;
            match fence.info {
                "json format" => {
                    if std::mem::take(&mut group_is_used) {
                        group.clear();
                    }
                    group.push(format_example(&fence, None)?);
                }
                "json good" => page.formats.push(format_example(&fence, None)?),
                "cldata good" | "cldata bad" => {
                    let (text, marks) = without_caret_lines(fence.body);
                    if marks.is_empty() == (fence.info == "cldata bad") {
                        return Err(format!("line {line}: a bad example has a caret line, a good one has none"));
                    }
                    if group.is_empty() {
                        page.cldata.push(CldataExample { line, text, marks });
                    } else {
                        group_is_used = true;
                        let (bad, formats) = (!marks.is_empty(), group.clone());
                        page.tapes.push(TapeExample { line, text, marks, bad, cldata: true, formats });
                    }
                }
                "tape good" | "tape bad" | "tape bad open" => {
                    group_is_used = true;
                    let (mut text, marks) = without_caret_lines(fence.body);
                    if fence.info.ends_with("open") {
                        text.pop();
                    }
                    let bad = fence.info != "tape good";
                    if marks.is_empty() == bad {
                        return Err(format!("line {line}: a bad tape has a caret line, a good tape has none"));
                    }
                    if group.is_empty() {
                        return Err(format!("line {line}: no format stands before this tape"));
                    }
                    page.tapes.push(TapeExample { line, text, marks, bad, cldata: false, formats: group.clone() });
                }
                info => match info.strip_prefix("json bad ").and_then(|fault| fault.split_once(' ')) {
                    Some((path, quoted)) => {
                        let marked = quoted.trim_matches('"').to_owned();
                        page.formats.push(format_example(&fence, Some((path.to_owned(), marked)))?);
                    }
                    None => return Err(format!("line {line}: a fence of unknown kind, {info:?}")),
                },
            }
        }
        Ok(page)
    }
}

fn fences(markdown: &str) -> Result<Vec<Fence<'_>>, String> {
    let mut fences = Vec::new();
    let mut open: Option<(usize, &str, usize)> = None;
    let mut at = 0;
    for (index, line) in markdown.split_inclusive('\n').enumerate() {
        if let Some(info) = line.trim_end().strip_prefix("```") {
            open = match open {
                None => Some((index + 1, info, at + line.len())),
                Some((line, info, from)) => {
                    fences.push(Fence { line, info, body: &markdown[from..at] });
                    None
                }
            };
        }
        at += line.len();
    }
    match open {
        Some((line, ..)) => Err(format!("line {line}: a fence without an end")),
        None => Ok(fences),
    }
}

/// A tape without its caret lines, and the places in the lines above that they mark: by characters, the line end
/// counting as one.
fn without_caret_lines(body: &str) -> (String, Vec<Mark>) {
    let mut text = String::new();
    let mut marks = Vec::new();
    let mut above = 0;
    for line in body.split_inclusive('\n') {
        let carets = line.trim();
        if carets.is_empty() || carets.chars().any(|c| c != '^') {
            above = text.len();
            text.push_str(line);
            continue;
        }
        let column = line.chars().take_while(|&c| c != '^').count();
        let byte = |column: usize| {
            let marked = text[above..].char_indices().nth(column);
            marked.map_or(text.len(), |(at, _)| above + at)
        };
        let range = byte(column)..byte(column + carets.len());
        marks.push(Mark { range, line_end: text.trim_end_matches('\n').len().max(above) });
    }
    (text, marks)
}

fn format_example(fence: &Fence<'_>, fault: Option<(String, String)>) -> Result<FormatExample, String> {
    let line = fence.line;
    let value = json::read(fence.body).map_err(|error| format!("line {line}: {error}"))?;
    let (format, problems) =
        Format::read(&value).map_err(|error| format!("line {line}: {}: {}", error.field, error.message))?;
    Ok(FormatExample { line, format, problems, fault })
}
