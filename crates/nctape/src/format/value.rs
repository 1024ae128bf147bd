//! Settings as plain values: how a format crosses into and out of the core, whatever the language outside.

use std::collections::BTreeMap;

/// A plain value: what JSON can say.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Nothing: the same as leaving the field out.
    Null,
    /// True or false.
    Flag(bool),
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
    /// A list.
    List(Vec<Value>),
    /// Named values, in their order.
    Map(Vec<(String, Value)>),
}

impl Value {
    /// What it is, for a message.
    pub fn describe(&self) -> String {
        match self {
            Value::Null => "nothing".to_owned(),
            Value::Flag(flag) => flag.to_string(),
            Value::Number(number) => number.to_string(),
            Value::Text(text) if text.chars().count() > 40 => {
                format!("\"{}…\"", text.chars().take(40).collect::<String>())
            }
            Value::Text(text) => format!("\"{text}\""),
            Value::List(_) => "a list".to_owned(),
            Value::Map(_) => "a set of fields".to_owned(),
        }
    }

    /// The value of a field of a map; `None` where it is missing or null.
    pub fn get(&self, field: &str) -> Option<&Value> {
        match self {
            Value::Map(fields) => {
                fields.iter().find(|(name, value)| name == field && *value != Value::Null).map(|(_, value)| value)
            }
            _ => None,
        }
    }
}

/// A setting that can be read from a value and written as one.
pub trait Setting: Sized {
    /// How a page may let a person edit it.
    const KIND: &'static str;
    /// Reads it; `None` where the value is not one of its kind.
    fn read(value: &Value) -> Option<Self>;
    /// Writes it.
    fn write(&self) -> Value;
    /// What is allowed, for a message.
    fn allowed() -> String;
    /// The words and titles, where it is one of a few.
    fn choices() -> Vec<(&'static str, &'static str)> {
        Vec::new()
    }
}

/// Implements [`Setting`] for enums made by `choices!`.
macro_rules! choice_settings {
    ($($name:ty),+) => { $(
        impl Setting for $name {
            const KIND: &'static str = "choice";
            fn read(value: &Value) -> Option<Self> {
                match value {
                    Value::Text(word) => Self::from_word(word),
                    _ => None,
                }
            }
            fn write(&self) -> Value {
                Value::Text(self.word().to_owned())
            }
            fn allowed() -> String {
                let words: Vec<String> = Self::ALL.iter().map(|choice| format!("\"{}\"", choice.1)).collect();
                format!("one of {}", words.join(", "))
            }
            fn choices() -> Vec<(&'static str, &'static str)> {
                Self::ALL.iter().map(|choice| (choice.1, choice.2)).collect()
            }
        }
    )+ };
}
pub(crate) use choice_settings;

impl Setting for bool {
    const KIND: &'static str = "flag";
    fn read(value: &Value) -> Option<Self> {
        if let Value::Flag(flag) = value { Some(*flag) } else { None }
    }
    fn write(&self) -> Value {
        Value::Flag(*self)
    }
    fn allowed() -> String {
        "true or false".to_owned()
    }
}

/// A finite number above zero.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Positive(pub f64);

impl Setting for Positive {
    const KIND: &'static str = "number";
    fn read(value: &Value) -> Option<Self> {
        number(value).filter(|number| *number > 0.0).map(Positive)
    }
    fn write(&self) -> Value {
        Value::Number(self.0)
    }
    fn allowed() -> String {
        "a number above 0".to_owned()
    }
}

/// A whole number from 0 to 9: a count of digits or places.
impl Setting for u8 {
    const KIND: &'static str = "number";
    fn read(value: &Value) -> Option<Self> {
        number(value).filter(|n| (0.0..=9.0).contains(n) && *n == n.trunc()).map(|n| n as u8)
    }
    fn write(&self) -> Value {
        Value::Number(f64::from(*self))
    }
    fn allowed() -> String {
        "a whole number from 0 to 9".to_owned()
    }
}

/// Speeds by name: numbers that are not negative.
impl Setting for BTreeMap<String, f64> {
    const KIND: &'static str = "numbers";
    fn read(value: &Value) -> Option<Self> {
        map(value, |value| number(value).filter(|number| *number >= 0.0))
    }
    fn write(&self) -> Value {
        Value::Map(self.iter().map(|(name, number)| (name.clone(), Value::Number(*number))).collect())
    }
    fn allowed() -> String {
        "numbers from 0 on by name, such as {\"1\": 120}".to_owned()
    }
}

/// Texts by name.
impl Setting for BTreeMap<String, String> {
    const KIND: &'static str = "texts";
    fn read(value: &Value) -> Option<Self> {
        map(value, |value| if let Value::Text(text) = value { Some(text.clone()) } else { None })
    }
    fn write(&self) -> Value {
        Value::Map(self.iter().map(|(name, text)| (name.clone(), Value::Text(text.clone()))).collect())
    }
    fn allowed() -> String {
        "texts by name, such as {\"G05\": \"hold\"}".to_owned()
    }
}

/// Ranges by name, lower end first.
impl Setting for BTreeMap<String, (f64, f64)> {
    const KIND: &'static str = "ranges";
    fn read(value: &Value) -> Option<Self> {
        map(value, |value| match value {
            Value::List(ends) if ends.len() == 2 => {
                Some((number(&ends[0])?, number(&ends[1])?)).filter(|(low, high)| low <= high)
            }
            _ => None,
        })
    }
    fn write(&self) -> Value {
        let range = |(low, high): &(f64, f64)| Value::List(vec![Value::Number(*low), Value::Number(*high)]);
        Value::Map(self.iter().map(|(name, ends)| (name.clone(), range(ends))).collect())
    }
    fn allowed() -> String {
        "ranges by name, such as {\"X\": [0, 85]}".to_owned()
    }
}

/// The finite number that a value is.
pub(crate) fn number(value: &Value) -> Option<f64> {
    if let Value::Number(number) = value { Some(*number).filter(|n| n.is_finite()) } else { None }
}

/// A map read entry by entry; `None` where it is no map or an entry does not fit.
pub(crate) fn map<T>(value: &Value, read: impl Fn(&Value) -> Option<T>) -> Option<BTreeMap<String, T>> {
    match value {
        Value::Map(fields) => {
            // One by one: to collect them would sort them first, with a sort for each type of map.
            let mut map = BTreeMap::new();
            for (name, value) in fields {
                map.insert(name.clone(), read(value)?);
            }
            Some(map)
        }
        _ => None,
    }
}
