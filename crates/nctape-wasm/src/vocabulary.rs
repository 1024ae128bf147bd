//! Names, texts and defaults about NC that a page shows: it knows none itself.

use crate::argument::{self, malformed};
use crate::offsets::Offsets;
use crate::value::{Plain, to_js};
use nctape::format::Itemized;
use nctape::function;
use nctape::span::SpanKind;
use nctape::{Standard, presets as core_presets, rules as core_rules};
use serde::Serialize;
use std::collections::BTreeMap;
use wasm_bindgen::prelude::*;

#[derive(Serialize)]
struct RuleView {
    rule: &'static str,
    aliases: Vec<&'static str>,
    name: &'static str,
    family: &'static str,
    title: &'static str,
    severity: BTreeMap<&'static str, Option<&'static str>>,
    clauses: Vec<String>,
    page: &'static str,
}

/// Every rule, with its page.
#[wasm_bindgen(unchecked_return_type = "Rule[]")]
pub fn rules() -> JsValue {
    let views: Vec<RuleView> = core_rules::ALL
        .iter()
        .map(|rule| RuleView {
            rule: rule.id(),
            aliases: rule.aliases(),
            name: rule.name,
            family: rule.family(),
            title: rule.title,
            severity: severities(rule),
            clauses: rule.clauses.iter().flat_map(|clause| clause.all()).collect(),
            page: rule.page,
        })
        .collect();
    to_js(&views)
}

fn severities(rule: &core_rules::Rule) -> BTreeMap<&'static str, Option<&'static str>> {
    // One by one: to collect them would take a sort for this one map.
    let mut severities = BTreeMap::new();
    for (standard, word, _) in Standard::ALL {
        severities.insert(*word, rule.verdicts.under(*standard).map(|verdict| verdict.severity.name()));
    }
    if let Some(verdict) = rule.verdicts.on_cldata() {
        severities.insert("iso3592", Some(verdict.severity.name()));
    }
    severities
}

#[derive(Serialize)]
struct PresetView {
    id: &'static str,
    title: &'static str,
    about: &'static str,
    kind: &'static str,
    format: Plain,
    source: &'static str,
    cursor: usize,
}

/// Tapes and CLDATA to begin with, the first visit's first.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn presets() -> JsValue {
    let views: Vec<PresetView> = core_presets::all()
        .into_iter()
        .map(|preset| PresetView {
            id: preset.id,
            title: preset.title,
            about: preset.about,
            kind: preset.kind.name(),
            format: Plain(preset.format.write()),
            source: preset.source,
            cursor: Offsets::new(preset.source).utf16(preset.cursor),
        })
        .collect();
    to_js(&views)
}

#[derive(Serialize)]
struct Named {
    id: &'static str,
    title: &'static str,
}

/// The standards that a format may follow.
#[wasm_bindgen(unchecked_return_type = "{ id: Standard, title: string }[]")]
pub fn standards() -> JsValue {
    to_js(&Standard::ALL.iter().map(|(_, id, title)| Named { id, title }).collect::<Vec<_>>())
}

/// The kinds of span by name; a kind k > 0 of a row or a path is the entry k - 1.
#[wasm_bindgen(js_name = spanKinds)]
pub fn span_kinds() -> Vec<String> {
    SpanKind::ALL.iter().map(|kind| kind.name().to_owned()).collect()
}

#[derive(Serialize)]
struct FieldView {
    path: String,
    label: &'static str,
    help: &'static str,
    kind: &'static str,
    choices: Vec<Choice>,
    default: &'static str,
    group: &'static str,
}

#[derive(Serialize)]
struct Choice {
    value: &'static str,
    title: &'static str,
}

/// How every field of a format is edited.
#[wasm_bindgen(js_name = formatFields, unchecked_return_type = "FormatField[]")]
pub fn format_fields(
    #[wasm_bindgen(unchecked_param_type = "Standard")] standard: &JsValue,
) -> Result<JsValue, JsValue> {
    let standard = standard.as_string().as_deref().and_then(Standard::from_word);
    let standard = standard.ok_or_else(|| malformed("standard", "a known standard is wanted"))?;
    let (classification, detail) = match standard {
        Standard::Iso2539 => ("As CSM 432 (annex C).", "As N3.G2.X+42.Y+32.F4.M2* (annex D)."),
        Standard::Iso1058 => ("As LSMD442 (annex C).", "As N3.G2.X+42.Y+32.F2.M2* (annex D)."),
        Standard::Rs274 => ("As c23.313.22 (Y-1702). It explains and never decides.", "As n3 g2 x+14 y+14 f21 m2*."),
    };
    let text = |path: &str, label, help, default| FieldView {
        path: path.to_owned(),
        label,
        help,
        kind: "text",
        choices: Vec::new(),
        default,
        group: "Shorthand",
    };
    let mut fields = vec![
        text("classification", "Classification", classification, "not stated"),
        text("detail", "Detail", detail, "none: nothing can be read"),
    ];
    fields.extend(Itemized::fields().into_iter().map(|field| FieldView {
        path: format!("itemized.{}", field.name),
        label: field.label,
        help: field.help,
        kind: field.kind,
        choices: field.choices.iter().map(|(value, title)| Choice { value, title }).collect(),
        default: field.default,
        group: field.group,
    }));
    Ok(to_js(&fields))
}

#[derive(Serialize)]
struct RowView {
    label: String,
    name: &'static str,
    tracks: Vec<u8>,
    parity: bool,
}

/// What each of the 256 rows means in a code.
#[wasm_bindgen(js_name = codeTable, unchecked_return_type = "RowMeaning[]")]
pub fn code_table(
    #[wasm_bindgen(unchecked_param_type = "\"iso\" | \"eia\"")] code: &JsValue,
) -> Result<JsValue, JsValue> {
    let code = code.as_string().as_deref().and_then(argument::code);
    let code = code.ok_or_else(|| malformed("code", "\"iso\" or \"eia\" is wanted"))?;
    let rows: Vec<RowView> = (0..=u8::MAX)
        .map(|row| {
            let (label, name) = code.meaning(row).unwrap_or((String::new(), "no character of this code"));
            let tracks = (1..=8).filter(|track| row & (1 << (track - 1)) != 0).collect();
            RowView { label, name, tracks, parity: code.parity_fits(row) }
        })
        .collect();
    Ok(to_js(&rows))
}

#[derive(Serialize)]
struct FunctionView {
    code: String,
    state: &'static str,
    meaning: &'static str,
    group: &'static str,
    acts: String,
    conflict: Option<&'static str>,
}

/// The tables of preparatory and miscellaneous functions: G00 to G99, M00 to M99.
#[wasm_bindgen(unchecked_return_type = "FunctionEntry[]")]
pub fn functions() -> JsValue {
    use function::{Miscellaneous, Preparatory, miscellaneous, preparatory};
    const UNASSIGNED: (&str, &str, &str, String) = ("unassigned", "", "", String::new());
    const PERMANENTLY: (&str, &str, &str, String) = ("permanently unassigned", "", "", String::new());
    let view = |letter: char, code: u8, found: (&'static str, &'static str, &'static str, String), conflict| {
        let (state, meaning, group, acts) = found;
        FunctionView { code: format!("{letter}{code:02}"), state, meaning, group, acts, conflict }
    };
    let preparatory_ones = (0..=99).map(|code| {
        let found = match preparatory(code) {
            Preparatory::Assigned(group, meaning) => {
                ("assigned", meaning, group.title(), group.hold().words().to_owned())
            }
            Preparatory::Unassigned => UNASSIGNED,
            Preparatory::PermanentlyUnassigned => PERMANENTLY,
        };
        view('G', code, found, function::preparatory_conflict(code))
    });
    let miscellaneous_ones = (0..=99).map(|code| {
        let found = match miscellaneous(code) {
            Miscellaneous::Assigned(matter, start, hold, meaning) => {
                ("assigned", meaning, matter.title(), format!("{}, {}", start.words(), hold.words()))
            }
            Miscellaneous::Unassigned => UNASSIGNED,
            Miscellaneous::PermanentlyUnassigned => PERMANENTLY,
        };
        view('M', code, found, function::miscellaneous_conflict(code))
    });
    to_js(&preparatory_ones.chain(miscellaneous_ones).collect::<Vec<_>>())
}
