//! A format as a plain value: reading one that may be wrong, and writing one.

use super::explain::FormatDiagnostic;
use super::value::Value;
use super::{Format, Itemized, Standard};
use crate::rules::format::{unknown_field, unusable_value};

/// A value that is no format at all: the field that makes it so.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Malformed {
    /// "format", or "standard".
    pub field: &'static str,
    /// What is allowed.
    pub message: String,
}

impl Format {
    /// Reads a format. What cannot be used is left out and reported; only what is no set of fields, or names no
    /// known standard, is refused.
    pub fn read(value: &Value) -> Result<(Format, Vec<FormatDiagnostic>), Malformed> {
        let Value::Map(fields) = value else {
            let message = format!("a format is a set of fields, not {}", value.describe());
            return Err(Malformed { field: "format", message });
        };
        let standard = match value.get("standard") {
            Some(Value::Text(word)) => Standard::from_word(word),
            _ => None,
        };
        let Some(standard) = standard else {
            let words: Vec<&str> = Standard::ALL.iter().map(|standard| standard.1).collect();
            let message = format!("the standard of a format is one of {}", words.join(", "));
            return Err(Malformed { field: "standard", message });
        };
        let mut format = Format::new(standard, "");
        let mut problems = Vec::new();
        for (name, value) in fields {
            match (name.as_str(), value) {
                ("standard", _) | (_, Value::Null) => {}
                ("classification", Value::Text(text)) => format.classification = Some(text.clone()),
                ("detail", Value::Text(text)) => format.detail = text.clone(),
                ("itemized", Value::Map(fields)) => {
                    read_itemized(&mut format.itemized, fields, standard, &mut problems)
                }
                ("classification" | "detail", _) => {
                    unusable_value::report(standard, name, value, "a text", &mut problems)
                }
                ("itemized", _) => unusable_value::report(standard, name, value, "a set of fields", &mut problems),
                _ => unknown_field::report(standard, name, &mut problems),
            }
        }
        Ok((format, problems))
    }

    /// Writes the stated fields.
    pub fn write(&self) -> Value {
        let mut fields = vec![("standard".to_owned(), Value::Text(self.standard.word().to_owned()))];
        if let Some(classification) = &self.classification {
            fields.push(("classification".to_owned(), Value::Text(classification.clone())));
        }
        fields.push(("detail".to_owned(), Value::Text(self.detail.clone())));
        let itemized = self.itemized.write();
        if !itemized.is_empty() {
            fields.push(("itemized".to_owned(), Value::Map(itemized)));
        }
        Value::Map(fields)
    }
}

fn read_itemized(
    itemized: &mut Itemized,
    fields: &[(String, Value)],
    standard: Standard,
    problems: &mut Vec<FormatDiagnostic>,
) {
    for (name, value) in fields {
        if *value == Value::Null {
            continue;
        }
        let path = format!("itemized.{name}");
        match itemized.read_field(name, value) {
            Ok(true) => {}
            Ok(false) => unknown_field::report(standard, &path, problems),
            Err(allowed) => unusable_value::report(standard, &path, value, &allowed, problems),
        }
    }
}
