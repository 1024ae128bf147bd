//! A format in words, and what is wrong with it.

use super::{Angles, Classification, Control, Designation, Format, Sign, Standard, System, Unit, Zeros};
use crate::diagnostic::{Diagnostic, Sink};
use crate::rules;

/// A finding about a format: in which of its fields, and where in that field's text.
#[derive(Clone, Debug)]
pub struct FormatDiagnostic {
    /// "classification", "detail", "itemized.feed" …
    pub path: String,
    /// The finding; its range is in bytes of the field's text.
    pub diagnostic: Diagnostic,
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
    let control = Control::new(format);
    let mut sentences = vec![format!("The format follows {}.", format.standard.title())];
    let mut diagnostics = Vec::new();
    if let Some(classification) = &control.classification {
        let mut found = Vec::new();
        rules::format::check_classification(classification, &control, &mut Sink::new(format.standard, &mut found));
        diagnostics
            .extend(found.into_iter().map(|d| FormatDiagnostic { path: "classification".to_owned(), diagnostic: d }));
        sentences.extend(classification_sentences(classification));
    } else if let Some(shorthand) = &format.classification {
        sentences.extend(eia_sentences(shorthand));
    }
    let mut found = Vec::new();
    rules::format::check_detail(&control.detail, &control, &mut Sink::new(format.standard, &mut found));
    diagnostics.extend(found.into_iter().map(|d| FormatDiagnostic { path: "detail".to_owned(), diagnostic: d }));
    rules::format::check_itemized(&control, &mut diagnostics);
    sentences.extend(control.detail.words.iter().map(|word| word_sentence(word, &control)));
    sentences.extend(itemized_sentences(&control));
    let place = |path: &str| ["classification", "detail"].iter().position(|field| *field == path).unwrap_or(2);
    diagnostics.sort_by_key(|found| (place(&found.path), found.diagnostic.range.start));
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

/// The EIA shorthand has no printed explanation at hand (Y-1702's figure 4 is lost), so its reading is a guess and
/// never decides anything.
fn eia_sentences(shorthand: &str) -> Vec<String> {
    let text = shorthand.trim().to_ascii_lowercase();
    let digits: Vec<u32> = text.chars().filter_map(|c| c.to_digit(10)).collect();
    let mut sentences = Vec::new();
    match text.chars().next() {
        Some('c') => sentences.push("c: probably a contouring control.".to_owned()),
        Some('p') => sentences.push("p: probably a positioning control.".to_owned()),
        _ => {}
    }
    if let [words, others, kind, before, after, channels, axes] = digits[..] {
        let kind = match kind {
            3 => "incremental dimensions",
            2 => "absolute dimensions with sign",
            1 => "absolute dimensions without sign",
            _ => "dimensions of a kind not known here",
        };
        sentences.push(format!(
            "{shorthand}: probably {words} dimension words, {others} other words, {kind}, {before} digits before and \
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
