//! A format in words, and what is wrong with it.

use super::{Angles, Classification, Control, Designation, Format, Shorthand, Sign, Standard, System, Unit, Zeros};
use crate::diagnostic::{Diagnostic, Sink};
use crate::order::order_by_key;
use crate::rules;

/// A finding about a format: in which of its fields, and where in that field's text.
#[derive(Clone, Debug)]
pub struct FormatDiagnostic {
    /// "classification", "detail", "itemized.feed" …
    pub path: String,
    /// The field's text; empty where the field is no text.
    pub text: String,
    /// The finding; its range is in bytes of the field's text.
    pub diagnostic: Diagnostic,
}

impl FormatDiagnostic {
    /// A finding about the text of a field.
    pub(crate) fn of(path: &str, text: &str, diagnostic: Diagnostic) -> FormatDiagnostic {
        FormatDiagnostic { path: path.to_owned(), text: text.to_owned(), diagnostic }
    }
}

/// A format in words.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// What the format makes of a control.
    pub control: Control,
    /// Sentences that a trainee understands, in the order of the format.
    pub sentences: Vec<String>,
    /// What is wrong with it, in the order of its fields.
    pub diagnostics: Vec<FormatDiagnostic>,
}

/// Explains a format and judges it.
pub fn explain(format: &Format) -> Explanation {
    explain_read(format, &[])
}

/// Explains a format that was read with problems: they are among its findings, and what follows from them is not.
pub fn explain_read(format: &Format, problems: &[FormatDiagnostic]) -> Explanation {
    let control = Control::new(format);
    let mut sentences = vec![format!("The format follows {}.", format.standard.title())];
    let mut diagnostics = problems.to_vec();
    if let Some(text) = &format.classification {
        let mut found = Vec::new();
        let mut sink = Sink::new(format.standard, &mut found);
        match &control.classification {
            Some(classification) => {
                rules::format::check_classification(classification, &control, &mut sink);
                sentences.extend(classification_sentences(classification));
            }
            None => {
                rules::format::check_shorthand(text, &mut sink);
                sentences.extend(eia_sentences(text));
            }
        }
        diagnostics.extend(found.into_iter().map(|found| FormatDiagnostic::of("classification", text, found)));
    }
    let mut found = Vec::new();
    // A detail that could not be read is no detail without words.
    if !problems.iter().any(|problem| problem.path == "detail") {
        rules::format::check_detail(&control.detail, &control, &mut Sink::new(format.standard, &mut found));
    }
    diagnostics.extend(found.into_iter().map(|found| FormatDiagnostic::of("detail", &format.detail, found)));
    rules::format::check_itemized(&control, &mut diagnostics);
    sentences.extend(control.detail.words.iter().map(|word| word_sentence(word, &control)));
    sentences.extend(itemized_sentences(&control));
    let place = |path: &str| ["classification", "detail"].iter().position(|field| *field == path).unwrap_or(2);
    order_by_key(&mut diagnostics, |found| (place(&found.path), found.diagnostic.range.start));
    Explanation { control, sentences, diagnostics }
}

/// A format in one line: "ISO 2539 · CSM 333 · N3.G2.XD33…".
pub fn one_line(format: &Format) -> String {
    let mut parts = vec![format.standard.title().to_owned()];
    parts.extend(format.classification.clone().filter(|text| !text.trim().is_empty()));
    parts.push(format.detail.clone());
    parts.join(" · ")
}

fn classification_sentences(found: &Classification) -> Vec<String> {
    let mut sentences = Vec::new();
    let kind = match found.letters.first().map(|letter| letter.0) {
        Some('C') => Some("C: the control positions and contours."),
        Some('P') => Some("P: the control positions."),
        Some('L') => Some("L: the control positions and cuts parallel to the axes."),
        _ => None,
    };
    sentences.extend(kind.map(str::to_owned));
    sentences.extend(found.system().map(|system| {
        match system {
            System::Address => "A: words have addresses and no tabs.",
            System::Tab => "T: words have tabs and no addresses.",
            System::TabAndAddress => "S: words have addresses; tabs are optional under ISO 2539, usual under ISO 1058.",
        }
        .to_owned()
    }));
    sentences.extend(found.unit().map(|unit| match unit {
        Unit::Millimetre => "M: lengths are in millimetres.".to_owned(),
        Unit::Inch => "I: lengths are in inches.".to_owned(),
    }));
    sentences.extend(found.angles().map(|angles| match angles {
        Angles::Turns => "R: angles are in decimal parts of a turn.".to_owned(),
        Angles::Degrees => "D: angles are in degrees.".to_owned(),
    }));
    sentences.extend(found.digits().map(|[all, dimension, simultaneous]| {
        format!("{all}{dimension}{simultaneous}: {all} motions, {dimension} of them by dimension words, {simultaneous} at a time.")
    }));
    sentences
}

/// What the EIA shorthand probably says.
fn eia_sentences(text: &str) -> Vec<String> {
    let mut sentences = Vec::new();
    let shorthand = text.trim();
    if let Some(read) = Shorthand::read(text) {
        match read.system {
            'c' => sentences.push("c: probably a contouring control.".to_owned()),
            'p' => sentences.push("p: probably a positioning control.".to_owned()),
            _ => {}
        }
        let kind = match read.kind {
            3 => "incremental dimensions",
            2 => "absolute dimensions with sign",
            1 => "absolute dimensions without sign",
            _ => "dimensions of a kind not known here",
        };
        let Shorthand { motions, others, before, after, channels, axes, .. } = read;
        sentences.push(format!(
            "{shorthand}: probably {motions} dimension words, {others} other words, {kind}, {before} digits before and \
             {after} behind the decimal sign, {channels} motions at a time, {axes} axes. The shorthand explains and \
             never decides: the detail and the itemized data hold."
        ));
    } else {
        sentences.push(format!("{shorthand}: a classification that could not be read; it decides nothing."));
    }
    sentences
}

fn word_sentence(word: &Designation, control: &Control) -> String {
    let text = word.text();
    let tab = if word.tab { ", after a tab" } else { "" };
    if !word.dimension {
        let what = match word.address {
            'N' => "sequence number",
            'G' => "preparatory function",
            'F' => "feed function",
            'S' => "spindle speed function",
            'T' => "tool function",
            'M' => "miscellaneous function",
            'A' | 'B' | 'C' | 'D' | 'E' => "symbolic motion or function",
            _ => "word",
        };
        let digits = if word.after == 0 {
            digits(word.width())
        } else {
            format!("{} before and {} behind the implicit decimal sign", digits(word.before), word.after)
        };
        return format!("{text}: {what}, {digits}{tab}.");
    }
    let what = if "IJK".contains(word.address) { "interpolation parameter" } else { "dimension" };
    let sign = match (control.standard(), word.sign) {
        (Standard::Rs274, Sign::Signed) => "with sign, absolute or incremental as the itemized data, G90 and G91 say",
        (Standard::Rs274, _) => "absolute or incremental as the itemized data, G90 and G91 say",
        (_, Sign::Positive) => "absolute, always positive and without sign",
        (_, Sign::Signed) => "absolute, with + or - sign",
        (_, Sign::Incremental) => "incremental, with + or - sign",
        (_, Sign::Both) => "absolute or incremental, as G90 and G91 say",
    };
    let zeros = match word.zeros {
        Zeros::All => "every digit is punched",
        Zeros::LeadingOmitted => "leading zeros may be left out",
        Zeros::TrailingOmitted => "trailing zeros may be left out",
    };
    format!(
        "{text}: {what} {}, {sign}, {} before and {} behind the implicit decimal sign; {zeros}{tab}.",
        word.address,
        digits(word.before),
        word.after
    )
}

/// "1 digit", "4 digits".
fn digits(count: u8) -> String {
    rules::digits(u16::from(count))
}

fn itemized_sentences(control: &Control) -> Vec<String> {
    let stated = control.format.itemized.write();
    let fields = super::Itemized::fields();
    stated
        .iter()
        .filter_map(|(name, value)| {
            let field = fields.iter().find(|field| field.name == name)?;
            let words = match value {
                super::value::Value::Text(word) => field
                    .choices
                    .iter()
                    .find(|choice| choice.0 == word)
                    .map_or(word.as_str(), |choice| choice.1)
                    .to_owned(),
                other => spoken(other),
            };
            Some(format!("{}: {words}.", field.label))
        })
        .collect()
}

fn spoken(value: &super::value::Value) -> String {
    use super::value::Value;
    match value {
        Value::Flag(true) => "yes".to_owned(),
        Value::Flag(false) => "no".to_owned(),
        Value::List(items) => items.iter().map(spoken).collect::<Vec<_>>().join(", "),
        Value::Map(fields) => {
            fields.iter().map(|(name, value)| format!("{name} = {}", spoken(value))).collect::<Vec<_>>().join(", ")
        }
        Value::Text(text) => text.clone(),
        other => other.describe(),
    }
}
